! The return map of Swirl to the power k, as AUTO-07p asks for a map (IPS = -1). start.txt: k, the start, the scene's numbers.
module swirl_map
  use iso_c_binding
  implicit none
  integer :: period = 1
  interface
     function swirl_step(numbers, period, z, image, derivative) bind(c) result(found)
       import :: c_int, c_double
       integer(c_int) :: found
       real(c_double), intent(in) :: numbers(*), z(*)
       integer(c_int), value :: period
       real(c_double), intent(out) :: image(*), derivative(*)
     end function swirl_step
  end interface
end module swirl_map

subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  use swirl_map
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: numbers(6), image(5), derivative(25)
  integer :: i
  numbers = (/ par(5), par(1), par(2), par(3), par(4), par(6) /)
  if (swirl_step(numbers, period, u, image, derivative) == 0) then
     f = u + 1d0                      ! nothing near is a fixed point
     if (ijac /= 0) then
        dfdu = 0d0
        do i = 1, ndim
           dfdu(i, i) = 1d0
        end do
     end if
     return
  end if
  f = image(1:ndim)
  if (ijac /= 0) dfdu = reshape(derivative(1:ndim * ndim), (/ ndim, ndim /))
end subroutine func

subroutine stpnt(ndim, u, par, t)
  use swirl_map
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t
  open(unit=77, file='start.txt', status='old', action='read')
  read(77, *) period
  read(77, *) u(1:ndim)
  read(77, *) par(1:6)
  close(77)
end subroutine stpnt

subroutine bcnd
end subroutine bcnd
subroutine icnd
end subroutine icnd
subroutine fopt
end subroutine fopt
subroutine pvls
end subroutine pvls
