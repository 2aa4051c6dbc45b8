#include "app/program.h"

int main(int argc, char** argv) { return cleave::runProgram(argc, argv); }
