#include "figures/html.h"

#include "plot/escape.h"

namespace cleave {
namespace {

constexpr size_t kShort = 24;  // no break in a cell of fewer bytes

}  // namespace

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::string htmlTable(const std::string& caption, const std::vector<HtmlRow>& rows, std::string_view alignment) {
    std::string html = "<div class=\"wide\"><table>\n<caption>" + escaped(caption) + "</caption>\n";
    for (size_t i = 0; i < rows.size(); ++i) {
        html += i == 0 ? "<thead><tr>" : "<tr>";
        const char* tag = i == 0 ? "th" : "td";
        for (size_t column = 0; column < rows[i].size(); ++column) {
            const std::string& cell = rows[i][column];
            std::string kind = alignment[column] == 'r' ? "n" : cell.size() < kShort ? "s" : "";
            if (cell.starts_with(kBest)) kind += kind.empty() ? "best" : " best";
            html += "<" + std::string(tag) + (i == 0 ? " scope=\"col\"" : "") +
                    (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + escaped(cell) + "</" + tag + ">";
        }
        html += i == 0 ? "</tr></thead>\n<tbody>\n" : "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace cleave
