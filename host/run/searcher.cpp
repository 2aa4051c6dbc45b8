#include "run/searcher.h"

#include <algorithm>

#include "base/error.h"
#include "gpu/commands.h"
#include "run/context_of.h"
#include "shared/overlap.h"

namespace cleave {
namespace {

struct Made {
    Search search;
    std::unique_ptr<Context> context;
};

uint64_t invalidOf(std::span<const vec3> points) {
    return static_cast<uint64_t>(
        std::count_if(points.begin(), points.end(), [](const vec3& p) { return !isFinite3(p); }));
}

}  // namespace

struct Searcher::State {
    State(Device& d, const SearchLimits& l) : device(d), limits(l), commands(d) {}

    Device& device;
    SearchLimits limits;
    Commands commands;
    Buffer items, answers, first, numbers;  // kept from call to call
    std::vector<Made> contexts;

    const Context& context(Search search) {
        const auto known =
            std::find_if(contexts.begin(), contexts.end(), [&](const Made& m) { return m.search == search; });
        if (known != contexts.end()) return *known->context;
        contexts.push_back({search, contextOf(device, {}, Building{}, 0, {&search, 1})});
        // CPU devices compile at the first dispatch.
        SearchInfo nothing;
        nothing.search = search;
        run(*contexts.back().context, nothing);
        return *contexts.back().context;
    }

    void reserve(Buffer& buffer, size_t bytes) {
        if (buffer.size() >= bytes) return;
        buffer = Buffer();
        buffer = Buffer(device, bytes);
    }

    template <class Item>
    SearchInfo placed(const DeviceTree& tree, std::span<const Item> some, Search search, size_t answerBytes) {
        reserve(items, some.size_bytes());
        reserve(answers, some.size() * answerBytes);
        items.upload(some);
        SearchInfo info;
        info.tree = tree.address();
        info.items = items.address();
        info.count = static_cast<uint32_t>(some.size());
        info.search = search;
        info.answers = answers.address();
        return info;
    }

    double run(const Context& made, const SearchInfo& info) {
        commands.begin();
        cmdSearch(commands.handle(), made, info);
        commands.run();
        return commands.milliseconds();
    }

    // Lists the triangles of boxes of which `counts` are known; those of several leaves come several times.
    void list(SearchInfo info, std::span<const uint32_t> counts, size_t firstBox, Overlaps& result) {
        std::vector<uint32_t> starts;
        uint32_t total = 0;
        for (const uint32_t count : counts) {
            starts.push_back(total);
            total += count;
        }
        if (total == 0) return;
        reserve(first, starts.size() * sizeof(uint32_t));
        reserve(numbers, total * sizeof(uint32_t));
        first.upload(std::span<const uint32_t>(starts));
        info.search = Search::listOverlaps;
        info.count = static_cast<uint32_t>(counts.size());
        info.first = first.address();
        info.numbers = numbers.address();
        result.ms += run(context(Search::listOverlaps), info);
        std::vector<uint32_t> found(total);
        numbers.read(0, found.data(), total * sizeof(uint32_t));
        for (size_t box = 0; box < counts.size(); ++box) {
            const auto begin = found.begin() + starts[box], end = begin + counts[box];
            std::sort(begin, end);
            for (auto at = begin, last = std::unique(begin, end); at != last; ++at)
                result.pairs.push_back({static_cast<uint32_t>(firstBox + box), *at});
        }
    }
};

Searcher::Searcher(Device& device, SearchLimits limits) : state_(std::make_unique<State>(device, limits)) {}
Searcher::~Searcher() = default;

Searcher::Nearest Searcher::nearest(const DeviceTree& tree, std::span<const vec3> points, float within) {
    State& s = *state_;
    const Context& made = s.context(Search::nearest);
    Nearest result{std::vector<Hit>(points.size()), 0.0, invalidOf(points)};
    for (size_t at = 0; at < points.size(); at += s.limits.batch) {
        const std::span<const vec3> some = points.subspan(at, std::min(s.limits.batch, points.size() - at));
        SearchInfo info = s.placed(tree, some, Search::nearest, sizeof(Hit));
        info.within = within;
        result.ms += s.run(made, info);
        s.answers.read(0, &result.hits[at], some.size() * sizeof(Hit));
    }
    return result;
}

Searcher::Contained Searcher::contains(const DeviceTree& tree, std::span<const vec3> points) {
    State& s = *state_;
    const Context& made = s.context(Search::contains);
    Contained result{std::vector<uint8_t>(points.size()), 0.0, invalidOf(points)};
    std::vector<uint32_t> answers;
    for (size_t at = 0; at < points.size(); at += s.limits.batch) {
        const std::span<const vec3> some = points.subspan(at, std::min(s.limits.batch, points.size() - at));
        result.ms += s.run(made, s.placed(tree, some, Search::contains, sizeof(uint32_t)));
        answers.resize(some.size());
        s.answers.read(0, answers.data(), some.size() * sizeof(uint32_t));
        std::transform(answers.begin(), answers.end(), result.isInside.begin() + static_cast<ptrdiff_t>(at),
                       [](uint32_t answer) { return static_cast<uint8_t>(answer); });
    }
    return result;
}

Searcher::Overlaps Searcher::overlaps(const DeviceTree& tree, std::span<const Box> boxes) {
    State& s = *state_;
    const Context& made = s.context(Search::countOverlaps);
    Overlaps result;
    result.invalid = static_cast<uint64_t>(std::count_if(boxes.begin(), boxes.end(), [](Box b) { return !isBox(b); }));
    std::vector<uint32_t> counts;
    for (size_t at = 0; at < boxes.size(); at += s.limits.batch) {
        const std::span<const Box> some = boxes.subspan(at, std::min(s.limits.batch, boxes.size() - at));
        SearchInfo info = s.placed(tree, some, Search::countOverlaps, sizeof(uint32_t));
        result.ms += s.run(made, info);
        counts.resize(some.size());
        s.answers.read(0, counts.data(), some.size() * sizeof(uint32_t));
        // Boxes whose numbers fit in memory together.
        for (size_t from = 0, to = 0; from < counts.size(); from = to) {
            uint64_t total = counts[to++];
            while (to < counts.size() && total + counts[to] <= s.limits.numbers) total += counts[to++];
            SearchInfo part = info;
            part.items += from * sizeof(Box);
            s.list(part, std::span(counts).subspan(from, to - from), at + from, result);
        }
    }
    return result;
}

}  // namespace cleave
