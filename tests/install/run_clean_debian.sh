#!/bin/bash
# The Debian package in a Debian that has nothing else: installed by apt, some installed studies and the first notebook run.
#   run_clean_debian.sh BUILD
# Exit code 77: it cannot be tried here.
set -euo pipefail
[ "$(id -u)" -eq 0 ] && command -v mmdebstrap dpkg-shlibdeps >/dev/null || exit 77
build=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sources() { grep -hv '^#' /etc/apt/sources.list.d/*.sources /etc/apt/sources.list 2>/dev/null || true; }

cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/cpack" >"$work/cpack.log" || { cat "$work/cpack.log"; exit 1; }
sources >"$work/sources"
mmdebstrap --variant=apt bookworm "$work/root" - <"$work/sources" 2>"$work/mmdebstrap.log" || { cat "$work/mmdebstrap.log"; exit 77; }
cp "$work"/cpack/*.deb "$work/root/root/ddapath.deb"
cp "$(dirname "$0")/../python/notebooks.py" "$work/root/root/"
cp /etc/resolv.conf /etc/hosts "$work/root/etc/" 2>/dev/null || true

cat >"$work/root/root/try.sh" <<'TRY'
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive OMP_NUM_THREADS=1
apt-get -qq update
apt-get -qq install -y --no-install-recommends /root/ddapath.deb >/root/apt.log 2>&1 || { cat /root/apt.log; exit 1; }
cd /root
dda --version
for deck in notched-beam softening-bar falling-beam crack-paths/unnotched.yaml; do
  case $deck in *.yaml) ;; *) deck=$deck/deck.yaml ;; esac
  dda run "/usr/share/ddapath/studies/$deck" --quiet --folder "runs/${deck%%/*}"
done
dda verify runs/notched-beam runs/falling-beam
dda animate runs/falling-beam --out fall.gif
dda new beam && dda run beam.yaml --quiet
python3 -c 'import ddapath; print(ddapath.find_program(), ddapath.read_run("runs/beam").status)'
apt-get -qq install -y --no-install-recommends python3-scipy >/root/apt.log 2>&1 || { cat /root/apt.log; exit 1; }   # for `stiffness`
mkdir first && cd first
python3 /root/notebooks.py /usr/share/ddapath/notebooks/first-beam.ipynb
[ -s figure-1.png ] && [ -s figure-2.png ]
TRY
mount -t proc proc "$work/root/proc"
trap 'umount "$work/root/proc"; rm -rf "$work"' EXIT
chroot "$work/root" bash /root/try.sh
