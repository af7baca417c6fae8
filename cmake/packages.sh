# Sourced by ./start, ./check and benchmarks/run: the Debian packages that Lares needs, and how to get them.

packages_to_build="build-essential cmake ninja-build pkg-config ccache mold ca-certificates
  libeigen3-dev libraptor2-dev libserd-dev libxml2-dev swi-prolog-nox libcpp-httplib-dev libssl-dev
  zlib1g-dev libzstd-dev libsqlite3-dev libpq-dev nlohmann-json3-dev libspdlog-dev libcli11-dev
  libyaml-cpp-dev libarchive-dev liboctomap-dev libpcre2-dev liburdfdom-dev
  liburdfdom-headers-dev"
packages_to_test="libgtest-dev libgmock-dev libbenchmark-dev clang-format-14 curl graphviz wrk
  libxml2-utils rasqal-utils postgresql zstd groff mandoc zsh fish mypy"
packages_to_compare="konclude" # what benchmarks measure Lares against
packages_to_test_long="debootstrap dpkg-dev clang-14 libclang-rt-14-dev clang-tidy-14"

# need_packages NAME… : installs what is missing, and says so first.
need_packages() {
  local missing=""
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" = "install ok installed" ] ||
      missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  echo "Lares needs these Debian packages, which are not installed yet:"
  echo " $missing" | fold -s -w 96
  local sudo=""
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || {
      echo "Please install them as root: apt-get install --no-install-recommends$missing" >&2
      return 1
    }
    sudo="sudo"
  fi
  echo "Installing them with apt-get …"
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get update -qq &&
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
      $missing >/dev/null
}
