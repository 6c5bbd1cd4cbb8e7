#include "studies/command_line.hpp"

int main(int argc, char** argv) { return dda::run_command_line(argc, argv); }
