Merge "surface.surface.msh";
Surface Loop(1) = {1};
Volume(1) = {1};
