#include "facade/host_builders.h"

#include <vector>

#include "builders/builder_names.h"
#include "run/device_builders.h"
#include "twin/twin_builder.h"

namespace cleave {

std::span<const TreeBuilder> hostBuilders() {
    static const std::vector<TreeBuilder> builders = [] {
        std::vector<TreeBuilder> all{
            {"twin", buildTwin, "the passes of gpu on the CPU, plainly written: the same tree"}};
        all.insert(all.end(), cpuBuilders().begin(), cpuBuilders().end());
        return all;
    }();
    return builders;
}

std::span<const std::pair<std::string_view, std::string_view>> allBuilders() {
    static const std::vector<std::pair<std::string_view, std::string_view>> builders = [] {
        std::vector<std::pair<std::string_view, std::string_view>> all;
        for (const DeviceBuilder& builder : deviceBuilders()) all.emplace_back(builder.name, builder.description);
        for (const TreeBuilder& builder : hostBuilders()) all.emplace_back(builder.name, builder.description);
        return all;
    }();
    return builders;
}

const TreeBuilder& hostBuilder(std::string_view name) {
    for (const TreeBuilder& builder : hostBuilders())
        if (builder.name == name) return builder;
    return cpuBuilder(name);  // throws, listing the names
}

}  // namespace cleave
