# Sourced by setup.sh: the HTTP library cpr for the language models (third_party/README.md). The system's
# package where there is one, else the source package of Debian testing, built into build/third_party/cpr
# once. Without either the program is built without language models.

cpr_prefix="$root/build/third_party/cpr"

# The sources.list line of the source packages of Debian testing, on the mirror this system uses already;
# fails if its package lists are not there.
debian_testing_sources() {
  local mirror
  mirror="$(apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(REPO_URI)' 'Created-By: Packages' \
    2>/dev/null | sed -n 's/^Debian|Debian|//p' | head -n 1)"
  [ -n "$mirror" ] && printf 'deb-src %s testing main\n' "$mirror"
}

# fetch_debian_source PACKAGE FOLDER: the files of a source package, without touching the system's own
# lists. apt checks the archive's signature.
fetch_debian_source() {
  local package="$1" folder="$2" options
  mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
  debian_testing_sources >"$folder/apt/sources.list" ||
    { as_root apt-get update -qq && debian_testing_sources >"$folder/apt/sources.list"; } || return 1
  options=(-qq -o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$folder/apt/lists" -o "Dir::Cache=$folder/apt/cache"
    -o APT::Sandbox::User=root -o Acquire::Languages=none)
  (cd "$folder" && apt-get "${options[@]}" update &&
    apt-get "${options[@]}" source --download-only "$package")
}

# unpack_upstream FOLDER: the upstream tarball of the one source package in it, into FOLDER/source, if it
# is the file that the package's description says it is.
unpack_upstream() {
  local folder="$1" sums
  sums="$(awk '/^Checksums-Sha256:/ {on = 1; next} /^[^ ]/ {on = 0}
               on && $3 ~ /\.orig\.tar\.[a-z0-9]+$/ {print $1 "  " $3}' "$folder"/*.dsc)"
  [ "$(wc -l <<<"$sums")" = 1 ] || return 1
  (cd "$folder" && sha256sum --quiet -c - <<<"$sums") || return 1
  mkdir "$folder/source"
  tar -xf "$folder/${sums#*  }" -C "$folder/source" --strip-components=1
}

# cpr turns warnings into errors, which a newer compiler would trip over; the flags of the build type come
# after its own.
build_cpr() {
  local folder="$1"
  cmake -S "$folder/source" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX="$cpr_prefix.part" -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCPR_USE_SYSTEM_CURL=ON -DCPR_BUILD_TESTS=OFF \
    -DCPR_ENABLE_LINTING=OFF "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG -Wno-error" &&
    cmake --build "$folder/build" &&
    cmake --install "$folder/build" && cp "$folder/source/LICENSE" "$cpr_prefix.part/"
}

install_cpr() {
  local folder log="$root/build/third_party/cpr.log"
  [ -f "$cpr_prefix/lib/cmake/cpr/cprConfig.cmake" ] || [ -f "$cpr_prefix.failed" ] && return
  dpkg-query -W -f '${db:Status-Status}' libcpr-dev 2>/dev/null | grep -qx installed && return
  say "Fetching and building cpr"
  mkdir -p "$root/build/third_party"
  folder="$(mktemp -d)"
  rm -rf "$cpr_prefix" "$cpr_prefix.part"
  if { fetch_debian_source cpr "$folder" && unpack_upstream "$folder" && build_cpr "$folder"; } \
    >"$log" 2>&1; then
    mv "$cpr_prefix.part" "$cpr_prefix"
  else
    touch "$cpr_prefix.failed"
    say "cpr could not be built (see $log): no language models in this build." \
      "Remove $cpr_prefix.failed to try again"
  fi
  rm -rf "$folder"
}
