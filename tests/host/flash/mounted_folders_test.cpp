#include "host/flash/uf2_drive.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using Folders = std::vector<std::filesystem::path>;

TEST_CASE("drives are mounted with FAT")
{
    CHECK(mounted_folders("22 27 0:21 / /proc rw,relatime - proc proc rw\n"
                          "27 1 254:0 / / rw,relatime - ext4 /dev/vda rw\n"
                          "30 27 8:1 / /media/eve/RPI-RP2 rw shared:7 master:2 - vfat /dev/sda1 rw,utf8\n"
                          "31 27 0:30 / /home/eve/far rw - nfs4 server:/ rw\n"
                          "32 27 0:31 / /mnt rw - tmpfs tmpfs rw\n"
                          "33 27 8:2 / /stick rw - exfat /dev/sdb1 rw") ==
          Folders{"/media/eve/RPI-RP2", "/stick"});
}

TEST_CASE("what the kernel escapes in names is read")
{
    CHECK(mounted_folders("30 27 8:1 / /media/A\\040B\\011\\134x\\04 rw - vfat /dev/sda1 rw\n") ==
          Folders{"/media/A B\t\\x\\04"});
}

TEST_CASE("lines of another form are left out")
{
    CHECK(mounted_folders("") == Folders{});
    CHECK(mounted_folders("\n30\n30 27 8:1 / /a rw -\n30 27 8:1 / /a rw vfat vfat\n - vfat\n") == Folders{});
}

}
