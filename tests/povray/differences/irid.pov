// A film of colours on a gray ball: Meniscus reads irid and leaves it away.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
light_source { -9*z, rgb 1 }
sphere { 0, 1 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 irid { 0.5 thickness 0.25 turbulence 0 } } }
