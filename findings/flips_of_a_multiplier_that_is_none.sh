#!/usr/bin/env bash
# AUTO-07p 0.9.2 (Debian 12's 0.9.2+dfsg-3): multipliers of a map's fixed points (IPS = -1) are as good as the state they are taken
# at, which EPSL and EPSU bound, and not as EPSS, which is said to be the tolerance of special points. A map of one dimension has the
# fixed point sin(p) and there, for every p, the multiplier -0.9999; its second derivative is 2e4. With EPSL = EPSU = 1e-6 and EPSS = 1e-5
# AUTO reports four period doublings between p = 0 and 1. There is none: the
# eigenvalues that it prints reach from -0.9999 to -1.0005. With EPSL = EPSU = 1e-10 it reports none. The derivative is given in closed
# form (JAC = -1). So flips of AUTO's are to be asked for again with a smaller EPSU, or at a cycle that is solved for anew.
# As root, with mmdebstrap: a root of these packages alone, in a temporary folder.
set -euo pipefail
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=apt --include=auto-07p,gfortran bookworm "$root/bookworm"
chroot "$root/bookworm" dpkg-query --show auto-07p
mkdir "$root/bookworm/work"
cat > "$root/bookworm/work/map.f90" <<'MAP'
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: away
  away = u(1) - sin(par(1))
  f(1) = u(1) - 1.9999d0 * away + 1d4 * away**2
  if (ijac /= 0) dfdu(1, 1) = -0.9999d0 + 2d4 * away
end subroutine func
subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t
  par(1) = 0d0
  u(1) = 0d0
end subroutine stpnt
subroutine bcnd
end subroutine bcnd
subroutine icnd
end subroutine icnd
subroutine fopt
end subroutine fopt
subroutine pvls
end subroutine pvls
MAP
# followed EPS: prints how many points of each type AUTO labels, and the least and the largest eigenvalue that it found
followed() {
    printf '%s\n' NDIM=1 IPS=-1 IRS=0 ILP=1 'ICP=[1]' NTST=10 NCOL=4 IAD=3 ISP=1 ISW=1 IPLT=0 NBC=0 NINT=0 NMX=1000 NPR=0 MXBF=0 \
        IID=2 ITMX=9 ITNW=7 NWTN=3 JAC=-1 "EPSL=$1" "EPSU=$1" EPSS=1e-5 DS=0.01 DSMIN=1e-5 DSMAX=0.02 IADS=1 NPAR=1 'THL={}' \
        'THU={}' 'UZR={}' RL0=-1 RL1=1 > "$root/bookworm/work/fort.2"
    chroot "$root/bookworm" sh -c 'cd /work && rm -f fort.7 fort.8 fort.9 && ./map' > "$root/said" 2> /dev/null
    local flips least largest
    flips=$(grep -c ' PD ' "$root/said" || true)
    read -r least largest < <(awk '/Eigenvalue  1/ {print $5}' "$root/bookworm/work/fort.9" | sort -g | sed -n '1p;$p' | xargs)
    printf 'EPSL = EPSU = %s: %s period doublings, eigenvalues %s to %s\n' "$1" "$flips" "$least" "$largest"
}
chroot "$root/bookworm" sh -c 'cd /work && gfortran -fopenmp -O map.f90 -o map /usr/lib/auto-07p/lib/*.o'
{ followed 1e-6; followed 1e-10; } | tee "$root/found"
diff "$root/found" - <<'FOUND'
EPSL = EPSU = 1e-6: 4 period doublings, eigenvalues -1.00048E+00 to -9.99900E-01
EPSL = EPSU = 1e-10: 0 period doublings, eigenvalues -9.99900E-01 to -9.99900E-01
FOUND
