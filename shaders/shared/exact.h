// The exact sign of determinants of floats, for decisions that must be right. Rare: callers come here where double
// leaves the sign open.
#ifndef CLEAVE_SHARED_EXACT_H
#define CLEAVE_SHARED_EXACT_H
#include "triangle.h"

CLEAVE_BEGIN

CLEAVE_CONST uint kMostParts = 48u;  // 4 determinants of 6 products of three floats, each the sum of two doubles

// det(x, a - o, b) with the exact sign and a relative error of at most 2^-50; where xIsPoint, x - o in place of x, and
// b - o in place of b where bIsPoint. By multilinearity these are up to four determinants of vectors as they are. Their
// products are summed without rounding, as an expansion of doubles that do not overlap (Shewchuk 1997, GROW-EXPANSION
// with zero elimination), whose largest part has the sign of the sum. Products of three floats of any size are in the
// range of double, with their last bits.
CLEAVE_FN double exactDeterminant(vec3 x, bool xIsPoint, vec3 a, vec3 b, bool bIsPoint, vec3 o) {
    double parts[kMostParts];
    uint count = 0u;
    for (uint m = 0u; m < 24u; m++) {
        // det(x, a, b) - det(x, o, b) - det(x, a, o) - det(o, a, b), a product of three at a time.
        uint which = m / 6u;
        if ((which == 2u && !bIsPoint) || (which == 3u && !xIsPoint)) continue;
        vec3 p = which == 3u ? o : x;
        vec3 q = which == 1u ? o : a;
        vec3 r = which == 2u ? o : b;
        uint i = m % 3u;
        bool crossed = m % 6u >= 3u;
        uint j = (i + (crossed ? 2u : 1u)) % 3u;
        uint k = (i + (crossed ? 1u : 2u)) % 3u;
        bool minus = crossed != (which > 0u);
        double two = double(q[j]) * double(r[k]);
        double third = double(minus ? -p[i] : p[i]);
        precise double product = two * third;
        double rest = productRest(two, third, product);
        for (uint added = 0u; added < 2u; added++) {
            precise double sum = added == 0u ? rest : product;
            uint kept = 0u;
            for (uint n = 0u; n < count; n++) {
                double part = parts[n];
                precise double with = sum + part;
                precise double taken = with - sum;
                precise double error = (sum - (with - taken)) + (part - taken);
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
