option(KFAST_TOGETHER "Compile sources of a library together, a dozen at a time, which is quicker" ${KFAST_SANITIZE})

# kfast_compile_together(<target> [APART <file>...]): for a library of many small sources, if KFAST_TOGETHER is on. Those
# apart have names in their anonymous namespaces that others have as well. Where it is off (scripts/tidy, and devices) an
# include that is missing is told, and a name that hides another one.
function(kfast_compile_together TARGET)
    if(KFAST_TOGETHER)
        cmake_parse_arguments(PARSE_ARGV 1 TOGETHER "" "" "APART")
        set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
        set_source_files_properties(${TOGETHER_APART} TARGET_DIRECTORY ${TARGET}
            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        target_compile_options(${TARGET} PRIVATE -Wno-shadow)
    endif()
endfunction()

# kfast_compile_core_together(<target>): for the sources of the core.
function(kfast_compile_core_together TARGET)
    set(CORE ${PROJECT_SOURCE_DIR}/core)
    kfast_compile_together(${TARGET}
        APART ${CORE}/beam/beam_player.cpp ${CORE}/beam/hatching.cpp ${CORE}/live_backbones.cpp)
endfunction()
