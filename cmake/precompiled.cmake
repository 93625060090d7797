option(KFAST_PRECOMPILE "Precompile standard headers, which is quicker" ${KFAST_SANITIZE})

# kfast_precompile_standard_headers(<target>): for a library of many sources, if KFAST_PRECOMPILE is on. Where it is off
# an include that is missing is told. g++ has false warnings of what is precompiled.
function(kfast_precompile_standard_headers TARGET)
    if(KFAST_PRECOMPILE)
        target_precompile_headers(${TARGET} PRIVATE
            <algorithm> <array> <cmath> <cstdint> <optional> <span> <string> <string_view> <utility> <vector>)
        target_compile_options(${TARGET} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-maybe-uninitialized;-Wno-stringop-overflow>")
    endif()
endfunction()
