# Every target of the project is compiled with these, on g++ and clang++ alike.
add_compile_options(
    -Wall -Wextra -Wpedantic -Wshadow -Werror
    $<$<COMPILE_LANGUAGE:CXX>:-Wconversion>
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>)
include_directories(${PROJECT_SOURCE_DIR})
