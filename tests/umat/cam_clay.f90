! SPDX-License-Identifier: MIT
! Modified Cam-clay as a UMAT: associated flow, implicit return (Borja and Lee 1990) with the elastic stiffness of the
! start of the increment. Written for the test alone, by another way than the program's own model.
!
! PROPS: lambda, kappa, Poisson's ratio, M, smallest p' for the stiffness [Pa].
! STATEV: p'c [Pa], void ratio e. Compression is positive inside.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, kstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  character(len=80) :: cmname
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, kstep(4), kinc
  real(dp) :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), sse, spd, scd, rpl, ddsddt(ntens), drplde(ntens), &
              drpldt, stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(1), dpred(1), props(nprops), &
              coords(3), drot(3, 3), pnewdt, celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp) :: lambda, kappa, nu, m, e, pc, pc0, p0, bulk, shear, p, q, p_trial, q_trial, volume, s(6), low, high, mid, f, &
              hardening
  integer :: i

  lambda = props(1); kappa = props(2); nu = props(3); m = props(4)
  pc0 = statev(1); e = statev(2)
  p0 = -sum(stress(1:3)) / 3
  bulk = (1 + e) * max(p0, props(5)) / kappa
  shear = 1.5_dp * bulk * (1 - 2 * nu) / (1 + nu)

  volume = -sum(dstran(1:3))
  p_trial = p0 + bulk * volume
  s = 0
  s(1:3) = stress(1:3) + p0 + 2 * shear * (dstran(1:3) + volume / 3)
  s(4:ntens) = stress(4:ntens) + shear * dstran(4:ntens)
  q_trial = sqrt(1.5_dp * (sum(s(1:3)**2) + 2 * sum(s(4:6)**2)))
  p = p_trial; q = q_trial; pc = pc0
  hardening = (1 + e) / (lambda - kappa)

  if (yield_at(0._dp) > 1e-12_dp * pc0**2) then
    ! f falls with the multiplier: bracket and halve it. Slow, and it cannot fail.
    low = 0
    high = 1 / bulk
    do while (yield_at(high) > 0)
      high = 2 * high
    end do
    do i = 1, 200
      mid = (low + high) / 2
      f = yield_at(mid)
      if (f > 0) then
        low = mid
      else
        high = mid
      end if
      if (high - low <= 1e-15_dp * high) exit
    end do
    f = yield_at(high)
  end if

  stress(1:3) = s(1:3) * ratio() - p
  stress(4:ntens) = s(4:ntens) * ratio()
  statev(1) = pc
  statev(2) = e - (1 + e) * volume
  ddsdde = 0
  do i = 1, 3
    ddsdde(i, 1:3) = bulk - 2 * shear / 3
    ddsdde(i, i) = bulk + 4 * shear / 3
  end do
  do i = 4, ntens
    ddsdde(i, i) = shear
  end do

contains

  real(dp) function ratio()
    ratio = 1
    if (q_trial > 0) ratio = q / q_trial
  end function

  ! f of (4.1) after plastic flow with the multiplier x; sets p, q and pc. The inner unknown is the plastic volume v,
  ! which p and pc both follow: v = x (2p - pc).
  real(dp) function yield_at(x)
    real(dp), intent(in) :: x
    real(dp) :: v, g, slope
    integer :: k
    v = 0
    do k = 1, 100
      p = p_trial - bulk * v
      pc = pc0 * exp(hardening * v)
      g = v - x * (2 * p - pc)
      slope = 1 + x * (2 * bulk + hardening * pc)
      v = v - g / slope
      if (abs(g) <= 1e-16_dp) exit
    end do
    p = p_trial - bulk * v
    pc = pc0 * exp(hardening * v)
    q = q_trial / (1 + 6 * shear * x / m**2)
    yield_at = (q / m)**2 - p * (pc - p)
  end function
end subroutine
