#include "support/runners.h"

#include <memory>

#include "support/device.h"

namespace cleave::test {
namespace {

template <class Runner, class... More>
Runner& shared(More&&... more) {
    static std::unique_ptr<Runner> made;
    if (!made) {
        made = std::make_unique<Runner>(device(), more...);
        beforeClose([] { made.reset(); });
    }
    return *made;
}

}  // namespace

Tracer& sharedTracer() { return shared<Tracer>(); }
GpuBuilder& sharedBuilder() { return shared<GpuBuilder>(); }
Renderer& sharedRenderer() { return shared<Renderer>(sharedTracer()); }

Searcher& sharedSearcher() {
    SearchLimits limits;
    limits.batch = 100;
    limits.numbers = 1000;
    return shared<Searcher>(limits);
}

}  // namespace cleave::test
