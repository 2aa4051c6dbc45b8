#include "app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "app/command_options.h"
#include "app/frame_files.h"
#include "app/option_kinds.h"
#include "app/run_options.h"
#include "base/text.h"

namespace cleave {
namespace {

constexpr std::array<std::pair<const char*, Command>, 8> kCommands = {{{"render", Command::render},
                                                                       {"trace", Command::trace},
                                                                       {"query", Command::query},
                                                                       {"info", Command::info},
                                                                       {"bench", Command::bench},
                                                                       {"report", Command::report},
                                                                       {"stability", Command::stability},
                                                                       {"devices", Command::devices}}};

std::unique_ptr<CLI::App> makeApp(Options& options) {
    auto app =
        std::make_unique<CLI::App>("cleave: ray queries on any Vulkan device, through kd-trees built there", "cleave");
    app->set_version_flag("--version", "cleave " CLEAVE_VERSION, "print the version and end");
    app->require_subcommand(1);
    addRender(*app->add_subcommand("render", "make a picture of a scene"), options);
    addTrace(*app->add_subcommand("trace", "answer the rays of a file"), options);
    addQuery(*app->add_subcommand("query", "ask about the points or boxes of a file"), options);
    addInfo(*app->add_subcommand("info", "describe a scene and its tree"), options);
    addBench(*app->add_subcommand("bench", "time builds and rays, after checking them"), options);
    addReport(*app->add_subcommand("report", "error against run time, as one page"), options);
    addStability(
        *app->add_subcommand("stability", "look for wrong answers: stiff cases, all builders, all kinds of rays"),
        options);
    addOutput(*app->add_subcommand("devices", "list what Vulkan offers here and what would be used"), options);
    return app;
}

std::string optionsOf(const CLI::App& command) {
    std::string names;
    for (const CLI::Option* option : command.get_options())
        if (option->nonpositional()) names += (names.empty() ? "" : ", ") + option->get_name();
    return names;
}

// Looked up before CLI11 does, whose message would not name what there is.
Command commandOf(const std::string& name) {
    for (const auto& [known, command] : kCommands)
        if (name == known) return command;
    throw UsageError("'" + name + "' is no command; there are: " + namesIn(kCommands));
}

const char* defaultOutput(Command command) {
    if (command == Command::trace) return "hits.npy";
    if (command == Command::query) return "out.npy";
    return command == Command::report ? "report" : "out.png";
}

void complete(Options& options) {
    if (samplesOf(options) > 1 && !takesSamples(options.view))
        throw UsageError(
            "--spp: a pixel of depth, steps and leaves shows one ray; several are for shaded, normals, path");
    if (options.splitMoving == Choice::on && options.query != Query::closest && options.query != Query::any)
        throw UsageError("--split-moving: all hits and counts are asked of one tree; leave it out");
    if (options.output.empty()) options.output = defaultOutput(options.command);
    for (size_t i = 0; options.command == Command::report && i < options.scenes.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (options.scenes[i].lexically_normal() == options.scenes[j].lexically_normal())
                throw UsageError("SCENE: '" + options.scenes[i].string() + "' is given twice");
    const auto hasFewBins = [](Builder builder) { return builder == Builder::gpu || builder == Builder::twin; };
    if (options.settings.bins > kBins &&
        (options.builders.empty() || std::any_of(options.builders.begin(), options.builders.end(), hasFewBins)))
        throw UsageError("--bins: gpu and twin have at most " + std::to_string(kBins) + "; for " +
                         std::to_string(options.settings.bins) + " name another --builder");
    const bool writes =
        options.command == Command::render || options.command == Command::trace || options.command == Command::query;
    if (writes && options.json && options.json->lexically_normal() == options.output.lexically_normal())
        throw UsageError("--json and -o name the same file");
    if (const auto why = needForCopies(options); why && options.instances == Choice::on)
        throw UsageError("--instances on: there can be none, since " + *why + "; leave it out");
    if (const auto why = needForWholeTree(options); why && options.lazy == Choice::on)
        throw UsageError("--lazy on: the whole tree is needed, since " + *why + "; leave it out");
    if (options.frames && !std::isfinite(static_cast<double>(options.frames->last) / options.frames->fps))
        throw UsageError("--fps: at so few frames per second the time of the last frame is no finite number");
    if (options.frames && options.json && isFrameFile(options.output, *options.json))
        throw UsageError("--json: '" + options.json->string() + "' is what a frame is called; choose another name");
}

constexpr uint32_t kQuickRuns = 2;

// To be typed again in a shell; the program by its name.
std::string lineOf(int argc, const char* const* argv) {
    std::string line = "cleave";
    for (const std::string_view word : std::span(argv + 1, static_cast<size_t>(argc - 1)))
        line += " " + shellWord(word);
    return line;
}

}  // namespace

std::optional<std::string> needForCopies(const Options& options) {
    if (options.tree) return "--tree names a single tree";
    if (options.query != Query::closest && options.query != Query::any)
        return "all hits, and counts of them, are found in a single tree";
    if (options.splitMoving == Choice::on) return "--split-moving on gives what moves a tree of its own";
    if (options.keep.any()) return "--keep-all leaves nothing out, copies included";
    if (options.command != Command::render) return std::nullopt;
    if (options.frames) return "frames are posed anew, with copies";
    if (options.view != View::depth && !countsSteps(options.view))
        return "only the views depth, steps and leaves show nothing of the triangles themselves";
    return std::nullopt;
}

std::optional<std::string> needForWholeTree(const Options& options) {
    if (options.tree) return "--tree names one that is there";
    if (options.namesBuilder && options.builders.front() != Builder::gpu) return "only the builder gpu builds lazily";
    if (options.query != Query::closest && options.query != Query::any)
        return "all hits, and counts of them, do not wait for a tree";
    if (options.splitMoving == Choice::on) return "--split-moving on gives what moves a tree of its own";
    if (options.instances == Choice::on) return "--instances on gives each mesh a tree";
    if (options.keep.any()) return "--keep-all leaves nothing out";
    if (options.command != Command::render) return std::nullopt;
    if (options.view == View::path) return "paths go everywhere, and do not wait for a tree";
    if (countsSteps(options.view)) return "the view shows it";
    return std::nullopt;
}

uint32_t defaultSamples(View view) { return view == View::path ? 64 : 1; }
uint32_t samplesOf(const Options& options) { return options.samples.value_or(defaultSamples(options.view)); }

uint64_t raysToJudge(const Options& options) { return options.check > 0 ? options.check : 2048; }

Request parseCommandLine(int argc, const char* const* argv) {
    const std::string first = argc > 1 ? argv[1] : "";
    if (argc < 2) throw UsageError("no command; there are: " + namesIn(kCommands) + " (see: cleave --help)");
    Options options;
    const std::unique_ptr<CLI::App> app = makeApp(options);
    if (!first.starts_with("-")) options.command = commandOf(first);
    try {
        app->parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return app->help();
    } catch (const CLI::CallForAllHelp&) {
        return app->help();
    } catch (const CLI::CallForVersion& version) {
        return std::string(version.what()) + "\n";
    } catch (const CLI::ExtrasError& error) {
        const CLI::App* command = first.starts_with("-") ? app.get() : app->get_subcommand(first);
        throw UsageError(std::string(error.what()) + "; there is: " + optionsOf(*command));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see: cleave " + (first.starts_with("-") ? "" : first + " ") +
                         "--help)");
    }
    if (options.command == Command::stability && app->get_subcommand("stability")->count("--builder") == 0)
        options.builders.clear();
    if (options.command == Command::report && options.quick && app->get_subcommand("report")->count("--runs") == 0)
        options.runs = kQuickRuns;
    options.line = lineOf(argc, argv);
    complete(options);
    return options;
}

Request parseViewerLine(int argc, const char* const* argv) {
    Options options;
    CLI::App app("cleave-view: fly through a scene, and see its tree", "cleave-view");
    addView(app, options);
    app.set_version_flag("--version", "cleave-view " CLEAVE_VERSION, "print the version and end");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return app.help();
    } catch (const CLI::CallForVersion& version) {
        return std::string(version.what()) + "\n";
    } catch (const CLI::ExtrasError& error) {
        throw UsageError(std::string(error.what()) + "; there is: " + optionsOf(app));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see: cleave-view --help)");
    }
    complete(options);
    return options;
}

}  // namespace cleave
