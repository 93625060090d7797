#include "host/commands/command_line.hpp"
#include "host/commands/lack_of_memory.hpp"

#include <fcntl.h>
#include <initializer_list>
#include <unistd.h>

namespace {

/// Before the constructors of globals, CLI11's among them, for they need memory.
[[gnu::constructor(101)]] void begin() { kfast::report_lack_of_memory_everywhere(); }

/// A file that is opened must not take the place of one that whoever started the program has closed: what it
/// prints would go there. To read or to write these fails as before.
void fill_closed_standard_files()
{
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(number, F_GETFD) < 0)
            ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY); // gets the lowest free number
}

}

int main(int count, char** arguments)
{
    fill_closed_standard_files();
    return kfast::run_command_line(count, arguments);
}
