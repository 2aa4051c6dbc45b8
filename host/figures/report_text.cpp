#include "figures/report_text.h"

#include <cmath>

#include "base/text.h"
#include "figures/html.h"
#include "plot/escape.h"

namespace cleave {

std::string milliseconds(double ms) { return fixed(ms, ms < 10.0 ? 3 : ms < 1000.0 ? 1 : 0); }

std::string rangeOf(const Spread& s) {
    return s.runs == 0 ? "-" : milliseconds(s.low) + "\u2013" + milliseconds(s.high);
}

std::string medianText(const Spread& s) { return s.runs == 0 ? "-" : milliseconds(s.median); }

Spread spreadOrNone(const std::vector<double>& runs) { return runs.empty() ? Spread{} : spreadOf(runs); }

std::string signedText(double value, int digits) {
    return value < 0.0 ? "\u2212" + fixed(-value, digits) : fixed(value, digits);
}

std::string errorText(double error) { return signedText(error, std::abs(error) < 10.0 ? 2 : 1); }

std::string frontMark(const ErrorRow& row) { return row.pareto ? "\u25CF" : ""; }

std::string headline(const std::string& html) { return "<h3>" + html + "</h3>\n"; }

std::string picturesOf(const SceneErrors& scene, const std::string& kind, const std::string& what) {
    std::string html = paragraph(what) + "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : scene.pictures)
        if (picture.kind == kind)
            html += "<figure><img alt=\"" + escaped(kind + ", " + picture.caption) + "\" src=\"data:image/png;base64," +
                    picture.png + "\"><figcaption>" + escaped(picture.caption) + "</figcaption></figure>\n";
    return html + "</div>\n";
}

}  // namespace cleave
