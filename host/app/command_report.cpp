// `cleave report`: error against run time, as a page and as JSON.
#include <algorithm>
#include <cctype>
#include <new>
#include <set>
#include <system_error>

#include "app/commands.h"
#include "app/measure_errors.h"
#include "app/report.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/report_json.h"
#include "figures/report_page.h"
#include "figures/report_plots.h"
#include "formats/base64.h"
#include "formats/write_file.h"
#include "gpu/instance.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

// The folder of the report, made if it is not there; gone again if nothing was written into it.
class ReportFolder {
  public:
    explicit ReportFolder(fs::path folder) : folder_(std::move(folder)) {
        made_ = makeFolder(folder_);
        requireWritable(page());
        requireWritable(figures());
    }
    ~ReportFolder() {
        std::error_code ignored;
        if (made_) fs::remove(folder_, ignored);  // an empty one only
    }
    ReportFolder(const ReportFolder&) = delete;
    ReportFolder& operator=(const ReportFolder&) = delete;

    fs::path page() const { return folder_ / "index.html"; }
    fs::path figures() const { return folder_ / "report.json"; }
    fs::path unfinished() const { return folder_ / "unfinished.jsonl"; }

    // Plots and pictures of a scene, whose file names begin with `stem`.
    void writePictures(const SceneErrors& scene, const std::string& stem) const {
        const fs::path pictures = folder_ / "pictures";
        makeFolder(pictures);
        for (const NamedPlot& plot : plotsOf(scene)) writeFile(pictures / (stem + "-" + plot.name + ".svg"), plot.svg);
        for (const ReportPicture& picture : scene.pictures) {
            std::string name = stem + "-" + picture.kind + "-" + picture.caption + ".png";
            std::replace(name.begin(), name.end(), ' ', '-');
            writeFile(pictures / name, std::span<const std::byte>(bytesOfBase64(picture.png)));
        }
    }

  private:
    fs::path folder_;
    bool made_ = false;

    // Says whether it was not there before.
    static bool makeFolder(const fs::path& folder) {
        std::error_code failure;
        const bool made = fs::create_directory(folder, failure);
        if (failure && !fs::exists(folder))
            throw Error("cannot make the folder " + folder.string() + ": " + failure.message() +
                        "; choose another place with -o");
        if (!fs::is_directory(folder))
            throw Error("cannot write a report to " + folder.string() + ": it is a file; name a folder with -o");
        return made;
    }
};

// What a run measures and where: an interrupted one goes on only where all of that is the same.
nlohmann::json identityOf(Run& run) {
    const Options& options = run.options;
    return {{"program", CLEAVE_VERSION},
            {"commit", CLEAVE_COMMIT},
            {"device", describe(run.device.device().physicalDevice(), 0).name},
            {"driver", describe(run.device.device().physicalDevice(), 0).driver},
            {"threads", options.settings.threads},
            {"runs", options.runs},
            {"check", options.check},
            {"quick", options.quick},
            {"interior", options.interior},
            {"peers", options.peers}};
}

// The part of a file name that the pictures of a scene begin with: of letters that any file system takes, and unlike
// the others.
std::string stemAmong(const std::string& name, std::set<std::string>& taken) {
    constexpr size_t kLongest = 60;
    std::string stem = fs::path(name).filename().stem().string().substr(0, kLongest);
    for (char& c : stem)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-') c = '-';
    if (stem.empty()) stem = "scene";
    std::string unlike = stem;
    for (int i = 2; !taken.insert(unlike).second; ++i) unlike = stem + "-" + std::to_string(i);
    return unlike;
}

// By the file's name, or by its path where two have the same name.
std::string nameAmong(const std::vector<fs::path>& files, const fs::path& file) {
    const auto same = [&](const fs::path& other) { return other.filename() == file.filename(); };
    const bool alone = std::count_if(files.begin(), files.end(), same) == 1;
    return (alone ? file.filename() : file).string();
}

// A scene that fails is told and shown; it does not take the others with it. Alone it is the end.
std::vector<SceneErrors> measureAll(Run& run, Notebook& notebook) {
    const std::vector<fs::path>& files = run.options.scenes;
    std::vector<SceneErrors> scenes;
    for (const fs::path& file : files) {
        const std::string name = nameAmong(files, file);
        const auto goOn = [&](const std::string& failure) {
            run.warn("going on without " + oneLine(name) + ": " + failure);
            scenes.push_back({});
            scenes.back().name = name;
            scenes.back().failure = failure;
        };
        try {
            scenes.push_back(measureErrors(run, notebook, file, name));
            run.print(oneLine(name) + ": measured\n");
        } catch (const Error& error) {
            if (files.size() == 1) throw;
            goOn(error.what());
        } catch (const std::bad_alloc&) {
            if (files.size() == 1) throw;
            goOn(file.string() + ": out of memory, on this machine, for this scene; use a smaller one");
        }
    }
    return scenes;
}

std::vector<std::pair<std::string, std::string>> leftOutOf(const Options& options,
                                                           const std::vector<SceneErrors>& scenes) {
    std::vector<std::pair<std::string, std::string>> all{
        {"twin", "gives the tree of gpu, bit for bit; it is written to be obvious, not to be timed"},
        {"gpu-exact", "gives the tree of exact, built on the device"},
        {"exact-nlog2n", "gives the tree of exact, more slowly"},
        {"brute", "makes no tree, so it has neither a cost nor a build"},
        {"the triangle test plain, in the plots of rays", "its answers are not the same, so its times are not either"}};
    if (options.quick) {
        all.emplace_back("other settings of gpu, shevtsov and the medians", "left out by --quick");
        all.emplace_back("three of four rays of each set, larger pictures with more samples, and runs beyond " +
                             std::to_string(options.runs),
                         "left out by --quick");
    } else {
        all.emplace_back("combinations of settings", "each is changed alone, the others at their defaults");
    }
    if (!options.peers) all.emplace_back("other ray tracers", "--peers measures them, too");
    for (const SceneErrors& scene : scenes) {
        if (!scene.failure.empty()) all.emplace_back(scene.name, scene.failure);
        for (const auto& [what, why] : scene.leftOut) all.emplace_back(scene.name + ": " + what, why);
    }
    return all;
}

ReportPage pageOf(Run& run, std::vector<SceneErrors> scenes, bool wentOn) {
    const Options& options = run.options;
    ReportPage page;
    page.version = CLEAVE_VERSION ", commit " CLEAVE_COMMIT;
    page.commandLine = options.line;
    page.device = run.device.name().value_or("");
    page.driver = describe(run.device.device().physicalDevice(), 0).driver;
    page.threads = options.settings.threads;
    page.runs = options.runs;
    page.interior = options.interior;
    page.wentOn = wentOn;
    page.settings = {nameOf(run.traversal()), uint64_t{raySetSize(options)} * raySetSize(options),
                     options.settings.costs, options.peers};
    page.leftOut = leftOutOf(options, scenes);
    page.scenes = std::move(scenes);
    return page;
}

void requireAllMeasured(const std::vector<SceneErrors>& scenes) {
    std::string failures;
    size_t failed = 0;
    for (const SceneErrors& scene : scenes) {
        if (scene.failure.empty()) continue;
        failures += (failures.empty() ? ": " : "; ") + scene.failure;
        ++failed;
    }
    if (failed > 0)
        throw Error(std::to_string(failed) + " of " + std::to_string(scenes.size()) + " scenes could not be measured" +
                    failures);
}

}  // namespace

void runReport(Run& run) {
    if (run.options.json) requireWritable(*run.options.json);
    const ReportFolder folder(run.options.output);
    Notebook notebook(folder.unfinished(), identityOf(run));
    const bool wentOn = notebook.takenOver() > 0;
    if (wentOn) run.print("going on where an earlier run was interrupted\n");
    const std::vector<SceneErrors> scenes = measureAll(run, notebook);
    const auto isMeasured = [](const SceneErrors& scene) { return scene.failure.empty(); };
    if (std::none_of(scenes.begin(), scenes.end(), isMeasured)) {
        notebook.remove();
        requireAllMeasured(scenes);
    }
    std::set<std::string> stems;
    for (const SceneErrors& scene : scenes)
        if (isMeasured(scene)) folder.writePictures(scene, stemAmong(scene.name, stems));
    const ReportPage page = pageOf(run, scenes, wentOn);
    const Json report = completed(run, reportJson(page));
    writeFile(folder.page(), reportHtml(page));
    writeJson(folder.figures(), report);
    if (run.options.json) writeJson(*run.options.json, report);
    notebook.remove();
    run.print(folder.page().string() + ", " + folder.figures().string() + "\n");
    requireAllMeasured(scenes);
}

}  // namespace cleave
