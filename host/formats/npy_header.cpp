#include "formats/npy_header.h"

#include <charconv>

namespace cleave {
namespace {

class Parser {
  public:
    explicit Parser(std::string_view text) : rest_(text) {}

    bool parse(NpyHeader& header) {
        if (!take('{')) return fail("its header is no dictionary");
        while (!take('}')) {
            std::string key;
            if (!string(key) || !take(':')) return fail("its header has a bad key");
            if (!entry(key, header)) return false;
            if (take(',')) continue;
            if (!take('}')) return fail("its header is no dictionary");
            break;
        }
        skipSpace();
        if (!rest_.empty()) return fail("its header goes on after the dictionary");
        return (hasDescr_ && hasOrder_ && hasShape_) || fail("its header lacks descr, fortran_order or shape");
    }
    const std::string& why() const { return why_; }

  private:
    bool fail(const std::string& why) {
        why_ = why;
        return false;
    }
    void skipSpace() {
        while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_.front()) != std::string_view::npos)
            rest_.remove_prefix(1);
    }
    bool take(char c) {
        skipSpace();
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    bool word(std::string_view w) {
        skipSpace();
        if (!rest_.starts_with(w)) return false;
        rest_.remove_prefix(w.size());
        return true;
    }
    // A string without escapes; none of the names has any.
    bool string(std::string& value) {
        skipSpace();
        if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return false;
        const size_t end = rest_.find(rest_.front(), 1);
        if (end == std::string_view::npos) return false;
        value = rest_.substr(1, end - 1);
        rest_.remove_prefix(end + 1);
        return value.find('\\') == std::string::npos;
    }
    // (), (1,), (1, 2), (1, 2,); a number in brackets without a comma is no tuple.
    bool tuple(std::vector<uint64_t>& values) {
        if (!take('(')) return false;
        bool comma = true;
        while (!take(')')) {
            uint64_t value = 0;
            skipSpace();
            const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
            if (!comma || error != std::errc{}) return false;
            rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
            values.push_back(value);
            comma = take(',');
        }
        return values.size() != 1 || comma;
    }
    bool entry(const std::string& key, NpyHeader& header) {
        bool* seen = key == "descr"           ? &hasDescr_
                     : key == "fortran_order" ? &hasOrder_
                     : key == "shape"         ? &hasShape_
                                              : nullptr;
        if (seen == nullptr) return fail("its header has an unknown key");
        if (*seen) return fail("its header has the key " + key + " twice");
        *seen = true;
        if (seen == &hasDescr_) return string(header.descr) || fail("its type is not '<f4'");
        if (seen == &hasShape_) return tuple(header.shape) || fail("its shape is not (N, 8)");
        header.fortranOrder = word("True");
        return header.fortranOrder || word("False") || fail("its fortran_order is neither True nor False");
    }

    std::string_view rest_;
    std::string why_;
    bool hasDescr_ = false;
    bool hasOrder_ = false;
    bool hasShape_ = false;
};

}  // namespace

std::optional<NpyHeader> parseNpyHeader(std::string_view text, std::string& why) {
    NpyHeader header;
    Parser parser(text);
    if (parser.parse(header)) return header;
    why = parser.why();
    return std::nullopt;
}

}  // namespace cleave
