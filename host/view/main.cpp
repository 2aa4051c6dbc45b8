#include "view/viewer.h"

int main(int argc, char** argv) { return cleave::runViewer(argc, argv); }
