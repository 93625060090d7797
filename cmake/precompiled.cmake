# kfast_precompile_standard_headers(<target>): for a library of many sources, and with sanitizers alone. Without them g++
# compiles it, which tells of an include that is missing, and has false warnings where headers are precompiled.
function(kfast_precompile_standard_headers TARGET)
    if(KFAST_SANITIZE)
        target_precompile_headers(${TARGET} PRIVATE
            <algorithm> <array> <cmath> <cstdint> <optional> <span> <string> <string_view> <utility> <vector>)
    endif()
endfunction()
