#include "scene/check_values.h"

#include "scene/refuse.h"

namespace cleave {
namespace {

bool isNumbers(const Json& value, size_t size) {
    bool good = value.is_array() && value.size() == size;
    for (size_t i = 0; good && i < size; ++i) good = value[i].is_number();
    return good;
}

std::string inside(const std::string& where, const char* name) { return where.empty() ? name : where + "." + name; }

}  // namespace

std::string at(const std::string& array, size_t index) { return array + "[" + std::to_string(index) + "]"; }

const Json* member(const Json& object, const char* name) {
    const auto it = object.find(name);
    return it == object.end() ? nullptr : &*it;
}

const Json* objectAt(const Json& object, const char* name, const std::string& where) {
    const Json* value = member(object, name);
    if (value != nullptr && !value->is_object()) refuseGltf(inside(where, name) + " is not an object");
    return value;
}

const Json& requiredObject(const Json& object, const char* name, const std::string& where) {
    const Json* value = objectAt(object, name, where);
    if (value == nullptr) refuseGltf(where + " has no object '" + name + "'");
    return *value;
}

const Json* extensionOf(const Json& object, const char* name, const std::string& where) {
    const Json* extensions = objectAt(object, "extensions", where);
    return extensions == nullptr ? nullptr : objectAt(*extensions, name, inside(where, "extensions"));
}

const Json& arrayOf(const Json& object, const char* name, const std::string& where) {
    static const Json kNone = Json::array();
    const Json* value = member(object, name);
    if (value == nullptr) return kNone;
    if (!value->is_array()) refuseGltf(inside(where, name) + " is not an array");
    return *value;
}

const Json& objectsOf(const Json& object, const char* name, const std::string& where) {
    const Json& array = arrayOf(object, name, where);
    for (size_t i = 0; i < array.size(); ++i)
        if (!array[i].is_object()) refuseGltf(at(inside(where, name), i) + " is no object");
    return array;
}

Target targetOf(const Json& document, const char* array) { return {array, arrayOf(document, array, "").size()}; }

void checkIndexValue(const Json& value, const Target& target, const std::string& where) {
    if (!value.is_number_unsigned() || value.get<uint64_t>() >= target.count)
        refuseGltf(where + " is " + value.dump() + ", and there are " + std::to_string(target.count) + " " +
                   target.noun);
}

bool checkIndex(const Json& object, const char* name, const Target& target, const std::string& where) {
    const Json* value = member(object, name);
    if (value != nullptr) checkIndexValue(*value, target, where + "." + name);
    return value != nullptr;
}

void requireIndex(const Json& object, const char* name, const Target& target, const std::string& where) {
    if (!checkIndex(object, name, target, where)) refuseGltf(where + " has no " + name);
}

void checkCount(const Json& object, const char* name, bool required, uint64_t most, const std::string& where) {
    const Json* value = member(object, name);
    if (value == nullptr && !required) return;
    if (value == nullptr) refuseGltf(where + " has no " + name);
    if (!value->is_number_unsigned() || value->get<uint64_t>() > most)
        refuseGltf(where + "." + name + " is " + value->dump() + ", and must be a whole number from 0 to " +
                   std::to_string(most));
}

void checkNumbers(const Json& object, const char* name, size_t size, const std::string& where) {
    const Json* value = member(object, name);
    if (value != nullptr && !isNumbers(*value, size))
        refuseGltf(where + "." + name + " must hold " + std::to_string(size) + " numbers");
}

void checkNumber(const Json& object, const char* name, bool required, const std::string& where) {
    const Json* value = member(object, name);
    if (value == nullptr && required) refuseGltf(where + " has no " + name);
    if (value != nullptr && !value->is_number())
        refuseGltf(where + "." + name + " is " + value->dump() + ", and must be a number");
}

void checkText(const Json& object, const char* name, const std::string& where) {
    const Json* value = member(object, name);
    if (value != nullptr && !value->is_string()) refuseGltf(where + "." + name + " is not a string");
}

void checkBool(const Json& object, const char* name, const std::string& where) {
    const Json* value = member(object, name);
    if (value != nullptr && !value->is_boolean()) refuseGltf(where + "." + name + " is neither true nor false");
}

uint64_t wholeOf(const Json& object, const char* name, uint64_t fallback) {
    const Json* value = member(object, name);
    return value == nullptr ? fallback : value->get<uint64_t>();
}

}  // namespace cleave
