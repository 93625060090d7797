option(KFAST_TOGETHER "Compile sources of a library together, dozens at a time, which is quicker" ${KFAST_SANITIZE})
set(KFAST_TOGETHER_AT_MOST 40)

# kfast_compile_together(<target> [APART <file>...] [ALONE <file>...]): for what has many small sources, if KFAST_TOGETHER is on.
# Those apart have names in their anonymous namespaces that others have as well, and are compiled together without
# these; those alone have names of some that are apart, too. Where it is off (scripts/tidy, and devices) an include that is
# missing is told, and a name that hides another one.
function(kfast_compile_together TARGET)
    if(NOT KFAST_TOGETHER OR "${TARGET}" IN_LIST KFAST_NEVER_TOGETHER)
        return()
    endif()
    cmake_parse_arguments(PARSE_ARGV 1 TOGETHER "" "" "APART;ALONE")
    get_target_property(SOURCES ${TARGET} SOURCES)
    foreach(SOURCE ${TOGETHER_APART} ${TOGETHER_ALONE})
        if(NOT SOURCE IN_LIST SOURCES)
            message(FATAL_ERROR "${SOURCE} is none of ${TARGET}'s sources: take it out of APART and ALONE")
        endif()
        list(REMOVE_ITEM SOURCES ${SOURCE})
    endforeach()
    list(LENGTH SOURCES COUNT)
    math(EXPR GROUPS "(${COUNT} + ${KFAST_TOGETHER_AT_MOST} - 1) / ${KFAST_TOGETHER_AT_MOST}")
    set(INDEX 0)
    foreach(SOURCE ${SOURCES})
        math(EXPR GROUP "${INDEX} * ${GROUPS} / ${COUNT}")
        set_source_files_properties(${SOURCE} TARGET_DIRECTORY ${TARGET} PROPERTIES UNITY_GROUP ${GROUP})
        math(EXPR INDEX "${INDEX} + 1")
    endforeach()
    set_source_files_properties(${TOGETHER_APART} TARGET_DIRECTORY ${TARGET} PROPERTIES UNITY_GROUP apart)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    target_compile_options(${TARGET} PRIVATE -Wno-shadow)
endfunction()

# kfast_compile_core_together(<target>): for the sources of the core.
function(kfast_compile_core_together TARGET)
    set(CORE ${PROJECT_SOURCE_DIR}/core)
    kfast_compile_together(${TARGET}
        APART ${CORE}/beam/beam_player.cpp ${CORE}/beam/hatching.cpp)
endfunction()
