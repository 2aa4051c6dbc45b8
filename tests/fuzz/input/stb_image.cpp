// stb's decoders once more, under the sanitizers of the harnesses.
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
