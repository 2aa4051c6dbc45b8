#include "app/commands.h"
#include "app/report.h"
#include "base/text.h"
#include "formats/write_file.h"

namespace cleave {

void runDevices(Run& run) {
    if (run.options.json) requireWritable(*run.options.json);
    std::vector<std::vector<std::string>> rows{{"", "index", "name", "type", "driver", "Vulkan", "lacks"}};
    Json devices = Json::array();
    for (const DeviceInfo& d : listDevices()) {
        rows.push_back({d.chosen ? "*" : "", std::to_string(d.index), oneLine(d.name), d.type, oneLine(d.driver),
                        d.apiVersion, d.usable ? "" : oneLine(d.unusableWhy)});
        devices.push_back({{"index", d.index},
                           {"name", d.name},
                           {"type", d.type},
                           {"driver", d.driver},
                           {"apiVersion", d.apiVersion},
                           {"usable", d.usable},
                           {"chosen", d.chosen},
                           {"unusableWhy", d.unusableWhy}});
    }
    if (rows.size() == 1)
        run.print("no Vulkan device here; install a driver, for example Mesa's lavapipe\n");
    else
        run.print(alignedTable(rows, "lrlllll") + "* is used where --device names no other\n");
    writeReport(run, {{"devices", devices}});
}

}  // namespace cleave
