// Under water, looking up at what is as steep as light can leave it: POV-Ray holds 1.33 in single precision, and reflects it all.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
#declare Sine = 1/1.33000002;
camera { location -y direction <Sine, sqrt(1 - Sine*Sine), 0> right 1e-9*z up 1e-9*vcross(z, <Sine, sqrt(1 - Sine*Sine), 0>) }
background { rgb 1 }
plane { y, 0 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.33 } }
plane { y, -2 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
