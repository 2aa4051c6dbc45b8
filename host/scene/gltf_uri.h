// Keeps a scene to the files in its own folder and below.
#pragma once

#include <filesystem>
#include <string>

namespace cleave {

bool isDataUri(const std::string& uri);

// Returns true for http:, file: and any other scheme (and so for C:\). Data URIs are not external.
bool isExternalUri(const std::string& uri);

// Returns the path of a relative URI, percent-decoded. Throws Error where it leaves `folder`: by its text (.., an
// absolute path, a scheme, with / or \) or by a symbolic link on disk. The file need not exist.
std::filesystem::path pathOfUri(const std::filesystem::path& folder, const std::string& uri);

}  // namespace cleave
