CLEAVE_ARRAY(ColourArray, vec4);  // linear RGBA
