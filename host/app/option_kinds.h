// Kinds of options: of a value that is parsed, of a number, of names from a table. What is wrong use ends in a
// CLI::ValidationError whose text says what there is to choose from.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/option_values.h"

namespace cleave {

template <typename Table>
std::string namesIn(const Table& table) {
    std::string names;
    for (const auto& [name, value] : table) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

template <typename Value, size_t n>
Value lookUp(const std::array<std::pair<const char*, Value>, n>& table, const std::string& option,
             const std::string& name) {
    for (const auto& [known, value] : table)
        if (name == known) return value;
    throw CLI::ValidationError(option, "'" + name + "' is not known; there is: " + namesIn(table));
}

// Adds an option whose text goes through `parse`; where that gives nothing, the use is wrong and `wanted` says why.
template <typename Value>
CLI::Option* addParsed(CLI::App& app, const std::string& name, const std::string& type, const std::string& text,
                       std::function<std::optional<Value>(const std::string&)> parse, std::function<void(Value)> set,
                       const std::string& wanted) {
    const auto read = [=](const std::string& given) {
        const std::optional<Value> value = parse(given);
        if (!value) throw CLI::ValidationError(name, "'" + given + "' is not " + wanted);
        set(*value);
    };
    return app.add_option_function<std::string>(name, read, text)->type_name(type);
}

template <typename Number>
void addWhole(CLI::App& app, const std::string& name, const std::string& text, Number& target, uint64_t least,
              uint64_t most) {
    addParsed<uint64_t>(
        app, name, "N", text, [=](const std::string& given) { return parseWhole(given, least, most); },
        [&target](uint64_t value) { target = static_cast<Number>(value); },
        "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

// A number from `least` to `most`, whose texts the refusal shows; the target is the default.
void addNumber(CLI::App& app, const std::string& name, const std::string& text, float& target,
               std::pair<double, const char*> least, std::pair<double, const char*> most);

template <typename Value, size_t n>
void addNamed(CLI::App& app, const std::string& name, const std::string& text, Value& target,
              const std::array<std::pair<const char*, Value>, n>& table) {
    app.add_option_function<std::string>(
           name, [&table, &target, name](const std::string& given) { target = lookUp(table, name, given); },
           text + " (" + namesIn(table) + ")")
        ->type_name("NAME");
}

// The same for a list, each name once; of one name unless `several`.
template <typename Value, size_t n>
void addNames(CLI::App& app, const std::string& name, const std::string& text, std::vector<Value>& target,
              const std::array<std::pair<const char*, Value>, n>& table, bool several) {
    const auto read = [&table, &target, name, several](const std::string& given) {
        target.clear();
        for (const std::string& one : several ? CLI::detail::split(given, ',') : std::vector<std::string>{given}) {
            const Value value = lookUp(table, name, one);
            if (std::find(target.begin(), target.end(), value) != target.end())
                throw CLI::ValidationError(name, "'" + one + "' is given twice");
            target.push_back(value);
        }
    };
    app.add_option_function<std::string>(name, read, text + " (" + namesIn(table) + ")")
        ->type_name(several ? "NAME,..." : "NAME");
}

}  // namespace cleave
