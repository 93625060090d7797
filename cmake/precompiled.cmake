option(KFAST_PRECOMPILE "Precompile standard headers: quicker, but an include that is missing is not found" ${KFAST_SANITIZE})

# kfast_precompile_standard_headers(<target>): for a library of many sources. Without it g++ compiles them in the preset
# host, which tells of an include that is missing, and has false warnings where headers are precompiled.
function(kfast_precompile_standard_headers TARGET)
    if(KFAST_PRECOMPILE)
        target_precompile_headers(${TARGET} PRIVATE
            <algorithm> <array> <cmath> <cstdint> <optional> <span> <string> <string_view> <utility> <vector>)
    endif()
endfunction()
