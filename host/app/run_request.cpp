#include "app/run_request.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "base/error.h"
#include "base/text.h"
#include "scene/not_found.h"

namespace cleave {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUse = 2;

int report(const std::string& text, int status) {
    std::fprintf(stderr, "error: %s\n", oneLine(text).c_str());
    return status;
}

// A full disk or a closed pipe shows only when the text is pushed out.
void requirePrinted() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw Error("cannot print to standard output: it is closed or full; send it elsewhere");
}

}  // namespace

int runRequest(const std::function<Request()>& parse, const std::function<void(const Options&)>& run) try {
    const Request request = parse();
    if (const auto* text = std::get_if<std::string>(&request))
        std::fputs(text->c_str(), stdout);
    else
        run(std::get<Options>(request));
    requirePrinted();
    return 0;
} catch (const UsageError& error) {
    return report(error.what(), kWrongUse);
} catch (const NotFound& error) {
    return report(error.what(), kWrongUse);
} catch (const std::bad_alloc&) {
    return report("out of memory, on this machine, for this scene; use a smaller scene or picture", kFailed);
} catch (const std::exception& error) {
    return report(error.what(), kFailed);
}

}  // namespace cleave
