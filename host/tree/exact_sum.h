// Sums of doubles without any rounding, for decisions that must be right: an expansion of non-overlapping doubles,
// grown by one number at a time (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates", GROW-EXPANSION with zero elimination). Exact while nothing overflows and no rounding error is below the
// range of double, which holds for sums of products of up to three floats of any size.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

namespace cleave {

class ExactSum {
  public:
    void add(double x) {
        size_t kept = 0;
        for (size_t i = 0; i < size_; ++i) {
            // Knuth's TWO-SUM: sum + error is exactly x + terms_[i].
            const double term = terms_[i];
            const double sum = x + term;
            const double part = sum - x;
            const double error = (x - (sum - part)) + (term - part);
            x = sum;
            if (error != 0.0) terms_[kept++] = error;
        }
        if (x != 0.0) terms_[kept++] = x;
        size_ = kept;
    }
    void addProduct(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    // Adds factor * other: exact where the products of the terms' last bits are in the range of double.
    void addMultiple(const ExactSum& other, double factor) {
        for (size_t i = 0; i < other.size_; ++i) addProduct(other.terms_[i], factor);
    }
    // a * b, on the same condition.
    friend ExactSum productOf(const ExactSum& a, const ExactSum& b) {
        ExactSum sum;
        for (size_t i = 0; i < a.size_; ++i) sum.addMultiple(b, a.terms_[i]);
        return sum;
    }
    // The largest term decides, since all the others together are smaller than its last place.
    int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0.0 ? 1 : -1; }
    // The sum, with a relative error of at most 2^-51.
    double value() const {
        double sum = 0.0;
        for (size_t i = 0; i < size_; ++i) sum += terms_[i];
        return sum;
    }

  private:
    // Non-overlapping terms carry at least one bit each of the 2100 that a double can express, and in practice 53:
    // sums of products of three floats span fewer than 900 bits and have at most 18 terms.
    std::array<double, 80> terms_{};
    size_t size_ = 0;
};

// Adds sign * det(a, b, c) of vectors of floats: a product of two is exact in double, a product of three in two
// doubles.
inline void addDeterminant(ExactSum& sum, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, double sign) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum.addProduct(double{b[j]} * double{c[k]}, sign * double{a[i]});
        sum.addProduct(double{b[k]} * double{c[j]}, -sign * double{a[i]});
    }
}

}  // namespace cleave
