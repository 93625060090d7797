# The images of the Pico, one for each kind of bus, and where they are found.
set(KFAST_PICO_BUSES spi i2c parallel xy)

set(KFAST_BOARD_BUILDS ${PROJECT_SOURCE_DIR}/build CACHE PATH
    "Where the presets of boards were built, in a folder each; their images are tested, and installed")

# kfast_install_firmware(<folder> [OPTIONAL]): from where the preset pico was built to where host/config/firmware_images.hpp
# looks; the .uf2 are for copying by hand.
function(kfast_install_firmware FOLDER)
    foreach(BUS ${KFAST_PICO_BUSES})
        install(FILES ${FOLDER}/pico-${BUS}.bin ${FOLDER}/pico-${BUS}.uf2
            DESTINATION share/kfast/firmware COMPONENT kfast ${ARGN})
    endforeach()
endfunction()
