# Address and undefined-behaviour sanitizers in everything; the first finding ends the program.
option(KFAST_SANITIZE "Build with sanitizers" OFF)
option(KFAST_EXPECTS "Trap where a caller breaks a contract: core/bytes/expects.hpp" ${KFAST_SANITIZE})
option(KFAST_FUZZ "Build the fuzz targets (clang only)" OFF)
set(KFAST_COMPILED_QUICKLY -O1 CACHE STRING "How code is compiled whose speed does not count")
if(KFAST_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()
if(KFAST_EXPECTS)
    add_compile_definitions(KFAST_EXPECTS)
endif()

# kfast_seldom_runs(<target>): a library that tests with sanitizers wait for while it is compiled, not while it runs.
function(kfast_seldom_runs TARGET)
    if(KFAST_SANITIZE)
        target_compile_options(${TARGET} PRIVATE ${KFAST_COMPILED_QUICKLY})
    endif()
endfunction()
