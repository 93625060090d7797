# Counters for each condition in the sources, which scripts/coverage reads (clang only).
option(KFAST_COVERAGE "Count which branches are taken" OFF)
if(KFAST_COVERAGE)
    add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
    add_link_options(-fprofile-instr-generate)
    # Counters of what is local to a source go by the name of the file that is compiled: these sources keep theirs, as
    # those that are compiled together have names like those of other libraries.
    set(KFAST_NEVER_TOGETHER kfast_core kfast_firmware kfast_link)
endif()
