! SPDX-License-Identifier: MIT
C     Undrained clay that loses strength with plastic shear: von Mises,
C       s_u = s_r + (s_p - s_r) exp(-g/g_s),
C     where g is the plastic shear strain that has been summed up.
C
C     PROPS:  1 Young's modulus [Pa]      2 Poisson's ratio
C             3 peak strength s_p [Pa]    4 residual strength s_r [Pa]
C             5 strain g_s, after which 63 % of the loss has happened
C     STATEV: 1 plastic shear strain g    2 strength s_u now [Pa]
C
C     gfortran -shared -fPIC -O2 -o softening_clay.so softening_clay.f
C
      SUBROUTINE UMAT(STRESS,STATEV,DDSDDE,SSE,SPD,SCD,
     1 RPL,DDSDDT,DRPLDE,DRPLDT,
     2 STRAN,DSTRAN,TIME,DTIME,TEMP,DTEMP,PREDEF,DPRED,CMNAME,
     3 NDI,NSHR,NTENS,NSTATV,PROPS,NPROPS,COORDS,DROT,PNEWDT,
     4 CELENT,DFGRD0,DFGRD1,NOEL,NPT,LAYER,KSPT,JSTEP,KINC)
C
      INCLUDE 'ABA_PARAM.INC'
C
      CHARACTER*80 CMNAME
      DIMENSION STRESS(NTENS),STATEV(NSTATV),
     1 DDSDDE(NTENS,NTENS),DDSDDT(NTENS),DRPLDE(NTENS),
     2 STRAN(NTENS),DSTRAN(NTENS),TIME(2),PREDEF(1),DPRED(1),
     3 PROPS(NPROPS),COORDS(3),DROT(3,3),DFGRD0(3,3),DFGRD1(3,3),
     4 JSTEP(4)
      DIMENSION S(6)
C
      G=PROPS(1)/(2*(1+PROPS(2)))
      BULK=PROPS(1)/(3*(1-2*PROPS(2)))
      PEAK=PROPS(3)
      REST=PROPS(4)
      SCALE=PROPS(5)
      GAMMA=STATEV(1)
C
C     Elastic trial: mean stress and deviator
      DVOL=DSTRAN(1)+DSTRAN(2)+DSTRAN(3)
      OLD=(STRESS(1)+STRESS(2)+STRESS(3))/3
      SMEAN=OLD+BULK*DVOL
      TAU2=0
      DO I=1,NTENS
        IF (I.LE.NDI) THEN
          S(I)=STRESS(I)-OLD+2*G*(DSTRAN(I)-DVOL/3)
          TAU2=TAU2+S(I)**2/2
        ELSE
          S(I)=STRESS(I)+G*DSTRAN(I)
          TAU2=TAU2+S(I)**2
        END IF
      END DO
      TAU=SQRT(TAU2)
C
C     Return: tau - G dg = s_u(g + dg), by Newton's method
      SU=REST+(PEAK-REST)*EXP(-GAMMA/SCALE)
      DG=0
      IF (TAU.GT.SU) THEN
        DO K=1,50
          SU=REST+(PEAK-REST)*EXP(-(GAMMA+DG)/SCALE)
          F=TAU-G*DG-SU
          IF (ABS(F).LT.1D-12*PEAK) GO TO 10
          SLOPE=G-(SU-REST)/SCALE
          IF (SLOPE.LE.0) GO TO 5
          DG=DG+F/SLOPE
        END DO
C       Strength falls faster than the soil unloads: there is no answer.
C       Talus then ends the run and names the point.
    5   PNEWDT=0.5D0
        RETURN
      END IF
   10 CONTINUE
      RATIO=1
      IF (TAU.GT.0) RATIO=(TAU-G*DG)/TAU
      DO I=1,NTENS
        STRESS(I)=S(I)*RATIO
        IF (I.LE.NDI) STRESS(I)=STRESS(I)+SMEAN
      END DO
      STATEV(1)=GAMMA+DG
      STATEV(2)=SU
      SPD=SPD+(TAU-G*DG)*DG
C
C     Elastic stiffness; Talus does not use it, Abaqus would want the consistent one
      DO I=1,NTENS
        DO J=1,NTENS
          DDSDDE(I,J)=0
          IF (I.LE.NDI.AND.J.LE.NDI) DDSDDE(I,J)=BULK-2*G/3
        END DO
        DDSDDE(I,I)=DDSDDE(I,I)+G
        IF (I.LE.NDI) DDSDDE(I,I)=DDSDDE(I,I)+G
      END DO
      RETURN
      END
