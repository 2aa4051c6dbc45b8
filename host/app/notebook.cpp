#include "app/notebook.h"

#include "base/error.h"

namespace cleave {
namespace {

using nlohmann::json;

constexpr const char* kName = "name";
constexpr const char* kFigure = "figure";

}  // namespace

Notebook::Notebook(std::filesystem::path file, const json& run) : file_(std::move(file)) {
    const std::string first = run.dump();
    takeOver(first);
    takenOver_ = entries_.size();
    out_.open(file_, std::ios::trunc);
    addLine(run);
    for (const auto& [name, figure] : entries_) addLine({{kName, name}, {kFigure, figure}});
}

Notebook::~Notebook() {
    if (entries_.empty()) remove();
}

void Notebook::takeOver(const std::string& run) {
    if (!std::filesystem::is_regular_file(file_)) return;
    std::ifstream in(file_);
    std::string line;
    if (!std::getline(in, line) || line != run) return;
    while (std::getline(in, line)) {
        const json entry = json::parse(line, nullptr, false);
        if (!entry.is_object() || !entry.contains(kName) || !entry[kName].is_string() || !entry.contains(kFigure))
            return;
        entries_[entry[kName]] = entry[kFigure];
    }
}

void Notebook::note(const std::string& name, const json& figure) {
    entries_[name] = figure;
    addLine({{kName, name}, {kFigure, figure}});
}

void Notebook::addLine(const json& line) {
    out_ << line.dump() << '\n' << std::flush;
    if (!out_) throw Error("cannot write " + file_.string() + "; free some space or choose another place");
}

void Notebook::remove() {
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace cleave
