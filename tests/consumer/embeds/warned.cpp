// Compiles, but not with cleave's own warnings as errors.
#include <cleave/cleave.hpp>
#include <cleave/scene.hpp>

unsigned char narrowed(int value) {
    int unused;
    return value;
}
