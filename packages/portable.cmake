# What starts the command of the tar that needs no installation: scripts/portable_tar.py.
if(KFAST_SANITIZE) # whose libraries are not linked statically
    return()
endif()
add_executable(kfast_launcher portable/launcher.c)
target_compile_definitions(kfast_launcher PRIVATE _GNU_SOURCE)
target_link_options(kfast_launcher PRIVATE -static)
