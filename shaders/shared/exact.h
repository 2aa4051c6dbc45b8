// The exact sign of determinants of floats, for decisions that must be right. Rare: callers come here where double
// leaves the sign open.
#ifndef CLEAVE_SHARED_EXACT_H
#define CLEAVE_SHARED_EXACT_H
#include "triangle.h"

CLEAVE_BEGIN

// Four determinants of 6 products of three floats, each the sum of two doubles; or one of differences of floats, whose
// products are the sum of four.
CLEAVE_CONST uint kMostParts = 48u;

// A difference in each component, and what its rounding left out.
struct Difference {
    dvec3 rounded;
    bool isExact;
};

CLEAVE_FN Difference differenceOf(vec3 a, vec3 b) {
    Difference d;
    d.rounded = dvec3(a) - dvec3(b);
    d.isExact = true;
    for (uint i = 0u; i < 3u; i++) {
        precise double whole = d.rounded[i];
        precise double part = whole - double(a[i]);
        precise double error = (double(a[i]) - (whole - part)) - (double(b[i]) + part);
        d.isExact = d.isExact && error == 0.0;
    }
    return d;
}

// det(x, a - o, b) with the exact sign and a relative error of at most 2^-50; where xIsPoint, x - o in place of x, and
// b - o in place of b where bIsPoint. Nearly always the differences are doubles; else multilinearity gives up to four
// determinants of the vectors as they are. The products are summed without rounding, as an expansion of doubles that do
// not overlap (Shewchuk 1997, GROW-EXPANSION with zero elimination), whose largest part has the sign of the sum.
// Products of three floats of any size are in the range of double, with their last bits.
CLEAVE_FN double exactDeterminant(vec3 x, bool xIsPoint, vec3 a, vec3 b, bool bIsPoint, vec3 o) {
    Difference ao = differenceOf(a, o);
    Difference xo = differenceOf(x, xIsPoint ? o : vec3(0.0f));
    Difference bo = differenceOf(b, bIsPoint ? o : vec3(0.0f));
    bool isOne = ao.isExact && xo.isExact && bo.isExact;
    double parts[kMostParts];
    uint count = 0u;
    for (uint m = 0u; m < (isOne ? 6u : 24u); m++) {
        // det(x, a, b) - det(x, o, b) - det(x, a, o) - det(o, a, b), a product of three at a time.
        uint which = m / 6u;
        if ((which == 2u && !bIsPoint) || (which == 3u && !xIsPoint)) continue;
        dvec3 p = isOne ? xo.rounded : which == 3u ? dvec3(o) : dvec3(x);
        dvec3 q = isOne ? ao.rounded : which == 1u ? dvec3(o) : dvec3(a);
        dvec3 r = isOne ? bo.rounded : which == 2u ? dvec3(o) : dvec3(b);
        uint i = m % 3u;
        bool crossed = m % 6u >= 3u;
        uint j = (i + (crossed ? 2u : 1u)) % 3u;
        uint k = (i + (crossed ? 1u : 2u)) % 3u;
        double third = crossed != (which > 0u) ? -p[i] : p[i];
        precise double two = q[j] * r[k];
        double twoRest = productRest(q[j], r[k], two);
        precise double high = two * third;
        precise double low = twoRest * third;
        for (uint part = 0u; part < 4u; part++) {
            precise double sum = part == 0u   ? productRest(twoRest, third, low)
                                 : part == 1u ? low
                                 : part == 2u ? productRest(two, third, high)
                                              : high;
            if (sum == 0.0) continue;
            uint kept = 0u;
            for (uint n = 0u; n < count; n++) {
                double term = parts[n];
                precise double with = sum + term;
                precise double taken = with - sum;
                precise double error = (sum - (with - taken)) + (term - taken);
                sum = with;
                if (error == 0.0) continue;
                parts[kept] = error;
                kept++;
            }
            count = kept;
            if (sum == 0.0) continue;
            parts[count] = sum;
            count++;
        }
    }
    precise double value = 0.0;
    for (uint n = 0u; n < count; n++) value = value + parts[n];
    return value;
}

CLEAVE_END
#endif
