#include "figures/report_page.h"

#include "base/text.h"
#include "figures/html.h"
#include "plot/escape.h"

namespace cleave {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { max-width: 62rem; margin: 2rem auto 4rem; padding: 0 1.2rem; color: #1a1a1a; background: #fff;
  font: 1rem/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.35rem; margin: 2.8rem 0 .4rem; padding-top: .8rem; border-top: 2px solid #1a1a1a; overflow-wrap: anywhere; }
h3 { font-size: 1.08rem; margin: 2rem 0 .3rem; }
p { margin: .4rem 0 .8rem; max-width: 46rem; }
code { font: .9em ui-monospace, "DejaVu Sans Mono", Menlo, monospace; overflow-wrap: anywhere; }
.plot { display: block; width: 100%; height: auto; margin: .6rem 0; font-family: inherit; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: .6rem 0 1rem; font-size: .84rem; line-height: 1.35; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding-bottom: .3rem; }
th, td { padding: .18rem .6rem .18rem 0; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #1a1a1a; font-weight: 600; }
td { border-bottom: 1px solid #e6e6e6; }
.n { text-align: right; } .n, .s { white-space: nowrap; }
.best { font-weight: 700; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(12.5rem, 1fr)); gap: .8rem; margin: .4rem 0 1.4rem; }
.pictures figure { margin: 0; } .pictures img { width: 100%; height: auto; display: block; border: 1px solid #ddd; }
figcaption { font-size: .86rem; }
.failure { border-left: 4px solid #D55E00; padding-left: .8rem; overflow-wrap: anywhere; }
@media print { body { max-width: none; margin: 0; font-size: 9.5pt; } h3, .plot, tr, figure { break-inside: avoid; }
  h3 { break-after: avoid; } .wide { overflow: visible; } a { color: inherit; text-decoration: none; } }
)";

}  // namespace

std::string reportHtml(const ReportPage& page) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>cleave: error against run time</title>\n<style>" +
        std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>Error against run time</h1>\n";
    html += paragraph(
        "What more time buys: how far each tree is from that of the builder <code>exact</code>, and each answer "
        "to a ray from the right one, against what it took. Below and to the left is better. A point is on the Pareto "
        "front, "
        "filled and joined by the dashed line, if none of the same scene is at most as large in both and "
        "smaller in one. Times are medians; their spread, lowest to highest of the runs, is beside each.");
    html += htmlTable(
        "How it was measured",
        {{"what", "value"},
         {"device", page.device},
         {"driver", page.driver},
         {"program", "cleave " + page.version},
         {"costs of the heuristic", fixed(page.settings.costs.traverse, 0) + " for an inner node, " +
                                        fixed(page.settings.costs.intersect, 0) + " for a triangle test"},
         {"command line", page.commandLine},
         {"runs", std::to_string(page.runs) + " of each, after a warm-up; in two turns, there and back"},
         {"interruptions",
          page.wentOn ? "some figures were taken before one; times from before and after it need not compare" : "none"},
         {"threads of CPU builders", std::to_string(page.threads)},
         {"primary rays", page.interior ? "from inside, for rooms" : "from outside, the benchmark's camera"}},
        "ll");
    for (const SceneErrors& scene : page.scenes) html += sceneHtml(scene, page.settings);
    std::vector<HtmlRow> rows{{"what", "why"}};
    for (const auto& [what, why] : page.leftOut) rows.push_back({what, why});
    html += "<h2>What was left out</h2>\n" + htmlTable("Not in this report", rows, "ll");
    return html + "</body>\n</html>\n";
}

}  // namespace cleave
