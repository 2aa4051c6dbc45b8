#include "view/script.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <tuple>

#include "app/option_values.h"
#include "base/error.h"
#include "base/text.h"

namespace cleave {
namespace {

enum class Takes { nothing, numbers, text, nameAndNumbers, onOff };

struct Form {
    std::string_view words;  // the step's first word, or two
    Verb verb;
    Takes takes = Takes::nothing;
    size_t count = 0;  // of numbers
    const char* usage = "";
};

constexpr Form kForms[] = {
    {"size", Verb::size, Takes::numbers, 2, "size W H"},
    {"eye", Verb::eye, Takes::numbers, 3, "eye X Y Z"},
    {"look", Verb::look, Takes::numbers, 3, "look X Y Z"},
    {"camera", Verb::camera, Takes::text, 0, "camera NAME"},
    {"view", Verb::view, Takes::text, 0, "view NAME"},
    {"builder", Verb::builder, Takes::text, 0, "builder NAME"},
    {"traversal", Verb::traversal, Takes::text, 0, "traversal NAME"},
    {"key", Verb::key, Takes::text, 0, "key K"},
    {"drag", Verb::drag, Takes::nameAndNumbers, 4, "drag left|right|middle X0 Y0 X1 Y1"},
    {"doubleclick", Verb::doubleClick, Takes::numbers, 2, "doubleclick X Y"},
    {"hover", Verb::hover, Takes::numbers, 2, "hover X Y"},
    {"scroll", Verb::scroll, Takes::numbers, 1, "scroll N"},
    {"drop", Verb::drop, Takes::text, 0, "drop FILE"},
    {"time", Verb::time, Takes::numbers, 1, "time S"},
    {"play", Verb::play},
    {"pause", Verb::pause},
    {"panels", Verb::panels, Takes::onOff, 0, "panels on|off"},
    {"overlay", Verb::overlay, Takes::numbers, 1, "overlay N"},
    {"wait frames", Verb::waitFrames, Takes::numbers, 1, "wait frames N"},
    {"wait idle", Verb::waitIdle},
    {"screenshot", Verb::screenshot, Takes::text, 0, "screenshot FILE.png"},
    {"expect error", Verb::expectError},
    {"quit", Verb::quit},
};

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream words(line);
    return {std::istream_iterator<std::string>(words), {}};
}

std::optional<Form> formOf(const std::vector<std::string>& words) {
    for (const Form& form : kForms) {
        if (form.words == words[0]) return form;
        if (words.size() > 1 && form.words == words[0] + " " + words[1]) return form;
    }
    return std::nullopt;
}

std::string knownSteps() {
    std::string names;
    for (const Form& form : kForms) names += (names.empty() ? "" : ", ") + std::string(form.words);
    return names;
}

// False where the words after the step's name are not what it takes.
bool fill(ScriptStep& step, const Form& form, std::vector<std::string> rest, const std::string& tail) {
    if (form.takes == Takes::text) {
        step.text = tail;  // names and files may have blanks
        return !tail.empty();
    }
    if (form.takes == Takes::onOff) {
        if (rest.size() != 1 || (rest[0] != "on" && rest[0] != "off")) return false;
        step.numbers[0] = rest[0] == "on" ? 1.0 : 0.0;
        return true;
    }
    if (form.takes == Takes::nameAndNumbers) {
        if (rest.empty()) return false;
        step.text = rest[0];
        rest.erase(rest.begin());
    }
    if (rest.size() != form.count) return false;
    for (size_t i = 0; i < rest.size(); ++i) {
        const std::optional<double> number = parseNumber(rest[i]);
        if (!number) return false;
        step.numbers[i] = *number;
    }
    return true;
}

// What follows the first `skip` words, without blanks at its ends.
std::string tailOf(const std::string& line, size_t skip) {
    constexpr const char* kBlank = " \t\r";
    size_t at = line.find_first_not_of(kBlank);
    for (size_t i = 0; i < skip && at != std::string::npos; ++i)
        at = line.find_first_not_of(kBlank, line.find_first_of(kBlank, at));
    if (at == std::string::npos) return "";
    return line.substr(at, line.find_last_not_of(kBlank) + 1 - at);
}

}  // namespace

std::vector<ScriptStep> parseScript(const std::string& text, const std::string& name) {
    std::vector<ScriptStep> steps;
    std::istringstream lines(text);
    std::string line;
    for (uint32_t number = 1; std::getline(lines, line); ++number) {
        const std::vector<std::string> words = wordsOf(line);
        if (words.empty() || words[0].starts_with("#")) continue;
        const std::string at = name + ", line " + std::to_string(number) + ": ";
        const std::optional<Form> form = formOf(words);
        if (!form) throw Error(at + "'" + oneLine(words[0]) + "' is no step; there are: " + knownSteps());
        const size_t own = form->words.find(' ') == std::string_view::npos ? 1 : 2;
        ScriptStep step{form->verb, number, "", {}};
        if (!fill(step, *form, {words.begin() + static_cast<ptrdiff_t>(own), words.end()}, tailOf(line, own)))
            throw Error(at + "a step of this kind is: " + (*form->usage ? form->usage : std::string(form->words)));
        steps.push_back(step);
    }
    return steps;
}

std::vector<ScriptStep> readScript(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw Error("cannot read the script " + oneLine(file.string()) + "; name a file that is there");
    return parseScript(text, oneLine(file.string()));
}

}  // namespace cleave
