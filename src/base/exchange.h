#pragma once

#include <filesystem>

#include "descriptor.h"

namespace roomgen::detail {

// What folders need of the operating system. (exchange_posix.cpp, exchange_windows.cpp)

/// Lets two folders change places in one step; false where the system cannot.
bool exchange(const std::filesystem::path& a, const std::filesystem::path& b);

/// May another folder take the place of this one? Not of one in which this program works (and so, mostly,
/// the shell that started it), of a mount point, or of what belongs to another user.
bool is_exchangeable(const std::filesystem::path& folder);

/// Gives `folder` the permissions of `other`.
bool take_over_mode(const std::filesystem::path& folder, const std::filesystem::path& other);

/// One name more for a file, which may be a link or a device; false if it cannot have one, or the name is
/// taken.
bool link_file(const std::filesystem::path& file, const std::filesystem::path& name);

/// Holds the folder until closed, or until the process is no more; empty if another one holds it.
Descriptor lock_folder(const std::filesystem::path& folder);

/// What is written to a file or a folder's list of names survives a crash from here on. Best effort: some
/// file systems know no such thing.
void keep_on_disk(const std::filesystem::path& file_or_folder);

}  // namespace roomgen::detail
