// A screen lit from behind that lets half of the light through to this side: the second number of `diffuse`, which Meniscus leaves away.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
light_source { 9*z, rgb 1 parallel point_at 0 }
polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> pigment { rgb 1 } finish { ambient 0 diffuse 0.8, 0.5 } }
