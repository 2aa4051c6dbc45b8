// What a long run has measured so far, kept in a file so that the same run goes on after an interruption.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace cleave {

// The file has a line of JSON per entry, after one that says what run it is of; a line is added when its figure is
// known. A line that was cut short is as if it had not been written.
class Notebook {
  public:
    // Takes the entries of the file over if it is of the same run, and starts it anew otherwise. Throws Error if it
    // cannot be written.
    Notebook(std::filesystem::path file, const nlohmann::json& run);
    // A file without a figure goes again.
    ~Notebook();
    Notebook(const Notebook&) = delete;
    Notebook& operator=(const Notebook&) = delete;

    // How many figures an earlier run had left.
    size_t takenOver() const { return takenOver_; }

    // The figure of that name: from an earlier run, or else measured now and noted.
    template <class Measure>
    auto once(const std::string& name, Measure measure) {
        using Figure = decltype(measure());
        if (const auto known = entries_.find(name); known != entries_.end()) {
            try {
                return known->second.template get<Figure>();
            } catch (const nlohmann::json::exception&) {  // the file was changed by someone: measured anew
            }
        }
        Figure figure = measure();
        note(name, figure);
        return figure;
    }

    // The run is complete: the file goes.
    void remove();

  private:
    std::filesystem::path file_;
    std::map<std::string, nlohmann::json> entries_;
    std::ofstream out_;
    size_t takenOver_ = 0;

    void takeOver(const std::string& run);
    void note(const std::string& name, const nlohmann::json& figure);
    void addLine(const nlohmann::json& line);
};

}  // namespace cleave
