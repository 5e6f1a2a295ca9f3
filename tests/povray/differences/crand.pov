// A grainy wall: the grain is a random number, and Meniscus takes others.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
light_source { -1e5*z, rgb 1 parallel point_at 0 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 crand 0.5 } }
