#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace kfast {

/// When the content of a file is brought to the disk.
enum class Sync {
    now,   ///< by commit()
    later, ///< by synchronize(), together with others of its folder
};

/// A file that appears whole or not at all: written under a temporary name in the same folder and renamed by
/// commit(). Without commit(), or when a signal ends the program, the temporary is removed and whatever was
/// at `target` stays as it was. At most four at a time.
///
/// With Sync::now, what commit() has renamed is on the disk, and the new name as well, when it returns: after
/// a loss of power there is either the old content or the new one. With Sync::later that holds after
/// synchronize(), and until then a loss of power may leave an empty file. A file system that cannot
/// synchronize a folder may lose the new name. If nothing but that fails, commit() throws, and the new
/// content is there all the same.
///
/// It has the permissions of the file that it replaces.
///
/// A target that is no regular file (a pipe, /dev/null) is written straight to. Every member but the
/// destructor throws Failure, which names `target`, when the disk is full, the folder is not writable and so
/// on.
class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path& target, Sync sync = Sync::now);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    /// All has been written: throws Failure if the last of it cannot be stored. For files that belong
    /// together, before the first of them is committed.
    void finish();
    void commit();

    /// For another program that writes the file; until commit().
    int descriptor() const { return descriptor_; }

private:
    void open_special();
    void open_temporary();
    void keep_permissions() const;
    [[noreturn]] void fail(int error_number) const;

    std::filesystem::path target_;
    Sync sync_;
    std::optional<std::filesystem::path> temporary_;
    int descriptor_ = -1;
};

/// For a program that ends at once: removes what was not committed. Needs no memory, and may be called by the
/// handler of a signal.
void remove_unfinished_files() noexcept;

/// Writes all of a file at once. Throws Failure.
void write_file(const std::filesystem::path& target, std::span<const std::byte> bytes, Sync sync = Sync::now);

/// Brings the files that were written to a folder with Sync::later to the disk, and their names: a thousand
/// small ones at once take a twentieth of the time that they take one by one. Throws Failure.
void synchronize(const std::filesystem::path& folder);

}
