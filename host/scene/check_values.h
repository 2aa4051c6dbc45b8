// What single values of a glTF's JSON must be, with sentences that say where they are not.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

namespace cleave {

using Json = nlohmann::json;

constexpr uint64_t kMaxCount = uint64_t(1) << 48;  // sums and products with strides stay within 64 bits

// "skins[0]"; "skins[0].joints[2]".
std::string at(const std::string& array, size_t index);

// The member of an object; null if there is none.
const Json* member(const Json& object, const char* name);
// A member that is an object; null if there is none. Throws if it is something else.
const Json* objectAt(const Json& object, const char* name, const std::string& where);
// The same, which must be there.
const Json& requiredObject(const Json& object, const char* name, const std::string& where);
// The object of an extension; null if there is none.
const Json* extensionOf(const Json& object, const char* name, const std::string& where);
// A member that is an array of objects, empty where it is missing. Throws if it is something else.
const Json& objectsOf(const Json& object, const char* member, const std::string& where = "");
// A member that is an array, empty where it is missing.
const Json& arrayOf(const Json& object, const char* name, const std::string& where);

// What an index leads to: so many objects, and their name.
struct Target {
    const char* noun;
    size_t count;
};
// The top-level array of that name.
Target targetOf(const Json& document, const char* array);

void checkIndexValue(const Json& value, const Target& target, const std::string& where);
// False if there is no such member.
bool checkIndex(const Json& object, const char* name, const Target& target, const std::string& where);
void requireIndex(const Json& object, const char* name, const Target& target, const std::string& where);

void checkCount(const Json& object, const char* name, bool required, uint64_t most, const std::string& where);
void checkNumbers(const Json& object, const char* name, size_t size, const std::string& where);
void checkNumber(const Json& object, const char* name, bool required, const std::string& where);
void checkText(const Json& object, const char* name, const std::string& where);
void checkBool(const Json& object, const char* name, const std::string& where);

}  // namespace cleave
