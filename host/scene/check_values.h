// Checks of single values of a glTF's JSON, whose sentences say where a value is wrong.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

namespace cleave {

using Json = nlohmann::json;

constexpr uint64_t kMaxCount = uint64_t(1) << 48;  // sums and products with strides stay within 64 bits

// Names an entry of an array in messages: "skins[0]", "skins[0].joints[2]".
std::string at(const std::string& array, size_t index);

// Returns the member of an object; null if there is none.
const Json* member(const Json& object, const char* name);
// Returns a member that is an object; null if there is none. Throws Error if it is something else.
const Json* objectAt(const Json& object, const char* name, const std::string& where);
// Returns the same, and throws Error also if there is none.
const Json& requiredObject(const Json& object, const char* name, const std::string& where);
// Returns the object of an extension; null if there is none.
const Json* extensionOf(const Json& object, const char* name, const std::string& where);
// Returns a member that is an array of objects, empty where it is missing. Throws Error if it is something else.
const Json& objectsOf(const Json& object, const char* member, const std::string& where = "");
// Returns a member that is an array, empty where it is missing. Throws Error if it is something else.
const Json& arrayOf(const Json& object, const char* name, const std::string& where);

// The objects that an index leads to.
struct Target {
    const char* noun;
    size_t count;
};
// Returns the objects of the top-level array of that name.
Target targetOf(const Json& document, const char* array);

// Each of these throws Error if the value is not what its name says.
void checkIndexValue(const Json& value, const Target& target, const std::string& where);
// Returns false if there is no such member.
bool checkIndex(const Json& object, const char* name, const Target& target, const std::string& where);
void requireIndex(const Json& object, const char* name, const Target& target, const std::string& where);

// Whole numbers from 0 to `most`.
void checkCount(const Json& object, const char* name, bool required, uint64_t most, const std::string& where);
// Of `size` numbers.
void checkNumbers(const Json& object, const char* name, size_t size, const std::string& where);
void checkNumber(const Json& object, const char* name, bool required, const std::string& where);
void checkText(const Json& object, const char* name, const std::string& where);
void checkBool(const Json& object, const char* name, const std::string& where);

// Returns a checked whole number, or `fallback` if there is no such member.
uint64_t wholeOf(const Json& object, const char* name, uint64_t fallback = 0);

}  // namespace cleave
