#include "scene/gltf_uri.h"

#include <algorithm>
#include <cctype>

#include "scene/refuse.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// RFC 3986, section 2.1. A % without two digits stands for itself, as careless exporters mean it.
std::string percentDecoded(const std::string& uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = i + 2 < uri.size() ? hexDigit(uri[i + 2]) : -1;
        const bool escape = uri[i] == '%' && high >= 0 && low >= 0;
        text += escape ? static_cast<char>(high * 16 + low) : uri[i];
        if (escape) i += 2;
    }
    return text;
}

// RFC 3986, section 3.1: a letter, then letters, digits, +, - or dots, up to the first colon.
bool hasScheme(const std::string& text) {
    const size_t colon = text.find(':');
    if (colon == std::string::npos || colon == 0) return false;
    if (std::isalpha(static_cast<unsigned char>(text[0])) == 0) return false;
    return std::all_of(text.begin(), text.begin() + std::string::difference_type(colon),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.'; });
}

bool leavesFolder(const fs::path& relative) {
    return relative.empty() || relative.is_absolute() || *relative.begin() == "..";
}

}  // namespace

bool isDataUri(const std::string& uri) { return uri.starts_with("data:"); }

bool isExternalUri(const std::string& uri) { return !isDataUri(uri) && hasScheme(percentDecoded(uri)); }

fs::path pathOfUri(const fs::path& folder, const std::string& uri) {
    const std::string advice = "put the file into the scene's folder, and name it by a relative path";
    auto refuse = [&](const std::string& why) { refuseGltf("the URI '" + uri.substr(0, 200) + "' " + why, advice); };
    std::string text = percentDecoded(uri);
    if (hasScheme(text)) refuse("is not a relative path");
    if (text.find('\0') != std::string::npos) refuse("holds a zero byte");
    std::replace(text.begin(), text.end(), '\\', '/');  // written by careless exporters, understood by Windows
    const fs::path relative = fs::path(text).lexically_normal();
    if (leavesFolder(relative)) refuse("leaves the scene's folder");
    std::error_code failed;
    const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, failed);
    const fs::path target = failed ? fs::path() : fs::weakly_canonical(home / relative, failed);
    if (failed || leavesFolder(target.lexically_relative(home))) refuse("leaves the scene's folder by a link");
    return home / relative;
}

}  // namespace cleave
