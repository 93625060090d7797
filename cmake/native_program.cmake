# Programs that run while device images are built: compiled for this machine beside the cross-compiler.
find_program(KFAST_NATIVE_CXX NAMES c++ g++ clang++ NO_CMAKE_FIND_ROOT_PATH REQUIRED
    DOC "A C++ compiler for the machine that builds")

# kfast_native_program(<name> SOURCES <file>... HEADERS <file>...): makes ${PROJECT_BINARY_DIR}/native/<name>. Names are
# written from the root of the repository; the headers are those whose change calls for another compilation.
function(kfast_native_program NAME)
    if(TARGET ${NAME}) # another image needs it as well
        return()
    endif()
    cmake_parse_arguments(PARSE_ARGV 1 PROGRAM "" "" "SOURCES;HEADERS")
    list(TRANSFORM PROGRAM_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/)
    list(TRANSFORM PROGRAM_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/native)
    add_custom_command(
        OUTPUT ${PROJECT_BINARY_DIR}/native/${NAME}
        COMMAND ${KFAST_NATIVE_CXX} -std=c++20 -O1 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
            -I ${PROJECT_SOURCE_DIR} ${PROGRAM_SOURCES} -o ${PROJECT_BINARY_DIR}/native/${NAME}
        DEPENDS ${PROGRAM_SOURCES} ${PROGRAM_HEADERS}
        COMMENT "Compiling the program ${NAME} of the build")
    add_custom_target(${NAME} DEPENDS ${PROJECT_BINARY_DIR}/native/${NAME})
endfunction()
