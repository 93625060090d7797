#include "host/commands/lack_of_memory.hpp"

#include "host/file/atomic_file.hpp"
#include "host/program/failure.hpp"

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <unistd.h>

namespace kfast {
namespace {

std::terminate_handler handler_before = nullptr;

bool is_lack_of_memory(const std::exception_ptr& thrown)
{
    if (!thrown)
        return false;
    try {
        std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

void print_at_once(std::string_view text)
{
    [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
}

[[noreturn]] void end()
{
    if (!is_lack_of_memory(std::current_exception())) {
        handler_before();
        std::abort();
    }
    remove_unfinished_files();
    for (const char* const part : {"kfast: ", lack_of_memory, "\n"})
        print_at_once(part);
    ::_exit(static_cast<int>(ExitStatus::wrong_input));
}

}

void report_lack_of_memory_everywhere() { handler_before = std::set_terminate(end); }

}
