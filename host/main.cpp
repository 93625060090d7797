#include "host/commands/command.hpp"

int main(int count, char** arguments) { return kfast::run_command_line(count, arguments); }
