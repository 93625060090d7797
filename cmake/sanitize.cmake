# Address and undefined-behaviour sanitizers in everything; the first finding ends the program.
option(KFAST_SANITIZE "Build with sanitizers" OFF)
option(KFAST_FUZZ "Build the fuzz targets (clang only)" OFF)
set(KFAST_COMPILED_QUICKLY -O1) # for code whose speed does not count
if(KFAST_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()
