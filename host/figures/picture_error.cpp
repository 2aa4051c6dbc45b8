#include "figures/picture_error.h"

#include <array>
#include <cmath>

#include "shared/tone.h"

namespace cleave {
namespace {

constexpr uint32_t kWindow = 11;
constexpr double kWindowSigma = 1.5;
constexpr double kRange = 255.0;
constexpr double kOfMeans = 0.01 * kRange * 0.01 * kRange;      // C1 of the paper
constexpr double kOfVariances = 0.03 * kRange * 0.03 * kRange;  // C2

double sumOfColours(const vec3& c) { return double{c.x} + double{c.y} + double{c.z}; }

double squaredDistance(const vec3& a, const vec3& b) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += (double{a[k]} - double{b[k]}) * (double{a[k]} - double{b[k]});
    return sum;
}

// `meanSquare` of a colour's error, as a share of the mean of the reference.
double relativeTo(std::span<const vec3> reference, double meanSquare) {
    double sum = 0.0;
    for (const vec3& c : reference) sum += sumOfColours(c);
    return std::sqrt(meanSquare) / (sum / (3.0 * static_cast<double>(reference.size())));
}

// Of Rec. 709, on encoded values.
double lumaOf(uint32_t pixel) {
    return 0.2126 * (pixel & 255u) + 0.7152 * (pixel >> 8 & 255u) + 0.0722 * (pixel >> 16 & 255u);
}

// The weights of one row of the window; those of the window are products of two.
std::array<double, kWindow> windowRow() {
    std::array<double, kWindow> row{};
    double sum = 0.0;
    for (uint32_t i = 0; i < kWindow; ++i) {
        const double away = (static_cast<double>(i) - 0.5 * (kWindow - 1)) / kWindowSigma;
        sum += row[i] = std::exp(-0.5 * away * away);
    }
    for (double& weight : row) weight /= sum;
    return row;
}

// Weighted sums over a window of two pictures.
struct Moments {
    double one = 0.0, other = 0.0, oneSquared = 0.0, otherSquared = 0.0, product = 0.0;

    double similarity() const {
        const double varianceOne = oneSquared - one * one, varianceOther = otherSquared - other * other;
        const double covariance = product - one * other;
        return (2.0 * one * other + kOfMeans) * (2.0 * covariance + kOfVariances) /
               ((one * one + other * other + kOfMeans) * (varianceOne + varianceOther + kOfVariances));
    }
};

}  // namespace

double relativeRmse(std::span<const vec3> picture, std::span<const vec3> reference) {
    double sum = 0.0;
    for (size_t i = 0; i < reference.size(); ++i) sum += squaredDistance(picture[i], reference[i]);
    return relativeTo(reference, sum / (3.0 * static_cast<double>(reference.size())));
}

MeanPicture meanOfParts(std::span<const std::vector<vec3>> parts) {
    const auto count = static_cast<double>(parts.size());
    MeanPicture mean;
    double squares = 0.0;
    for (size_t i = 0; i < parts.front().size(); ++i) {
        glm::dvec3 sum(0.0);
        for (const std::vector<vec3>& part : parts) sum += glm::dvec3(part[i]);
        mean.radiance.emplace_back(sum / count);
        for (const std::vector<vec3>& part : parts) squares += squaredDistance(part[i], mean.radiance.back());
    }
    const double variance = squares / (3.0 * static_cast<double>(mean.radiance.size()) * (count - 1.0));
    mean.error = relativeTo(mean.radiance, variance / count);
    return mean;
}

std::vector<uint32_t> shownPixels(std::span<const vec3> radiance) {
    std::vector<uint32_t> pixels;
    for (const vec3& c : radiance) pixels.push_back(packedColour(shownColour(kViewPath, c, vec4(0.0f), 1, 1.0f)));
    return pixels;
}

double structuralSimilarity(std::span<const uint32_t> one, std::span<const uint32_t> other, uint32_t width,
                            uint32_t height) {
    const std::array<double, kWindow> row = windowRow();
    double sum = 0.0;
    for (uint32_t y = 0; y + kWindow <= height; ++y)
        for (uint32_t x = 0; x + kWindow <= width; ++x) {
            Moments m;
            for (uint32_t j = 0; j < kWindow; ++j)
                for (uint32_t i = 0; i < kWindow; ++i) {
                    const size_t at = size_t{y + j} * width + x + i;
                    const double weight = row[i] * row[j], a = lumaOf(one[at]), b = lumaOf(other[at]);
                    m.one += weight * a;
                    m.other += weight * b;
                    m.oneSquared += weight * a * a;
                    m.otherSquared += weight * b * b;
                    m.product += weight * a * b;
                }
            sum += m.similarity();
        }
    return sum / static_cast<double>(size_t{width - kWindow + 1} * (height - kWindow + 1));
}

}  // namespace cleave
