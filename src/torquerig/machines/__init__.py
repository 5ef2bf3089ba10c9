"""Phase-level models of motors, whose torque ripple follows from windings, magnets and control.

permanent_magnet  R, L, flux linkage, back-EMF    back_emf        its shape: harmonics or trapezoid
six_step          Hall commutation (BLDC)         field_oriented  current loop in the rotor's frame (PMSM)
shaft             imposed speed, or two masses    demand          a torque, or a speed that a PI holds
drive_run         torque and currents over time   ripple_orders   the lines, as the torque-level model takes them
current_loop      PI gains from R, L, bandwidth   induction       torque over slip, speed under load
induction_run     its fluxes over time            control         what every control can do
kernel            the compiled loop               machine_row     a machine as the kernel takes it
checks            declared bounds of the numbers  winding         which slots fit which poles
"""
