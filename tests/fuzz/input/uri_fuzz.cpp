// Any text is a path within the scene's folder or an Error of one line, wherever dots, escapes and links lead.
#include "base/error.h"
#include "harness.h"
#include "scene/gltf_uri.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    const TimeLimit limit;
    namespace fs = std::filesystem;
    static const SceneFolder folder;
    static const std::string home = fs::canonical(folder.folder()).string() + "/";
    const std::string uri(reinterpret_cast<const char*>(data), size);
    try {
        // An independent judge: what the system itself resolves, with links followed, of all that exists.
        const fs::path path = cleave::pathOfUri(folder.folder(), uri);
        std::error_code missing;
        const fs::path real = fs::canonical(path, missing);
        if (!missing) require((real.string() + "/").starts_with(home), "a path stays in the folder", real.string());
        if (missing) require(!fs::exists(path, missing), "a path that exists can be resolved", path.string());
    } catch (const cleave::Error&) {  // its text is made fit for a line by loadGltf
    }
    return 0;
}
