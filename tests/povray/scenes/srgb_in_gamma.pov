// expect rmse 2e-5 but for 1 pixel: a ray that meets the floor thousands of units away is off by its rounding there
#version 3.7;
global_settings { assumed_gamma 2.2 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> srgb 0.9 }
background { srgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker color srgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
sphere { <0, 0.8, 0>, 0.7 pigment { srgbft <0.9, 0.5, 0.3, 0.6, 0.3> } finish { ambient 0.1 diffuse 0.3 phong 0.4 reflection { 0.05, 0.4 } } interior { ior 1.4 } }
