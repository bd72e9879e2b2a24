#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <fcntl.h>
#include <io.h>

#include <cstdint>

#include "exchange.h"

namespace roomgen::detail {

namespace fs = std::filesystem;

// Windows has no such step, so that results are moved into their folder file by file.
bool exchange(const fs::path&, const fs::path&) {
  return false;
}

bool is_exchangeable(const fs::path&) {
  return false;
}

bool take_over_mode(const fs::path&, const fs::path&) {
  return false;
}

bool link_file(const fs::path& file, const fs::path& name) {
  return ::CreateHardLinkW(name.c_str(), file.c_str(), nullptr) != 0;
}

// Who holds a folder has opened it for writing and lets nobody else do so; files in it, and its own
// name, may change all the same.
Descriptor lock_folder(const fs::path& folder) {
  const HANDLE handle =
      ::CreateFileW(folder.c_str(), FILE_ADD_FILE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return Descriptor();
  const int number = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_RDONLY | _O_NOINHERIT);
  if (number < 0) ::CloseHandle(handle);
  return Descriptor(number);
}

// Folders need nothing: their lists of names are in the journal.
void keep_on_disk(const fs::path& file_or_folder) {
  const Descriptor file(::_wopen(file_or_folder.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT));
  if (file) (void)file.sync();
}

}  // namespace roomgen::detail
